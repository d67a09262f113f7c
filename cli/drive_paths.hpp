// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "cli/drive_site.hpp"
#include "localization/validation.hpp"

namespace alignability::cli {

/// Paths of files as `evaluate` reads them, named after the files, not yet driven; what they say that is not followed is told on stderr.
/// Throws InputError, for a graph too.
std::vector<DrivenPath> read_paths(std::span<const std::filesystem::path> files);

/// The paths with their runs, driven with a progress bar. Throws Interrupted.
std::vector<DrivenPath> driven(std::vector<DrivenPath> paths, const DriveSite& site, TrialOptions trials);

/// Of profiles of errors along a path [m].
inline constexpr double kErrorStep = 0.5;

/// How far off one localizer was along one path.
struct LocalizerErrors {
  PathErrors over_all;
  std::vector<ErrorAlong> along;  ///< in steps of kErrorStep
};

/// Of a driven path and one of its localizers, by number; of a disk of that radius [m].
LocalizerErrors errors_of(const DrivenPath& path, std::size_t localizer, const ClearanceMap& clearance, double radius);

/// Tells on stderr which paths lead a robot of that radius [m] into an obstacle: they are driven all the same, through it.
void warn_of_collisions(std::span<const DrivenPath> paths, const ClearanceMap& clearance, double radius);

}  // namespace alignability::cli
