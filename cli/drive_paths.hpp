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

/// Drives them, with a progress bar. Throws Interrupted.
void drive_all(std::vector<DrivenPath>& paths, const DriveSite& site, TrialOptions trials);

}  // namespace alignability::cli
