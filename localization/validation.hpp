// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "costmap/alignability_map.hpp"
#include "localization/cell_errors.hpp"
#include "localization/path_errors.hpp"

namespace alignability {

/// A path and the runs along it.
struct DrivenPath {
  std::string name;
  std::vector<Pose2> path;
  std::vector<Drive> runs;
};

/// What errors are held against.
struct ErrorReference {
  const AlignabilityMap& map;
  const ClearanceMap& clearance;
  double radius = 0.0;    ///< of the robot [m]
  double settling = 2.0;  ///< the first metres of a drive, which do not count for cells
};

/// The layers that say how well a scan is held there, of those that a map may have; the greater the better.
inline constexpr std::array kReadingLayers{"alpha", "centred", "voxel", "robust", "information"};

/// How far off a localizer was, and how well the map told so.
struct Validation {
  struct OfLayer {
    std::string layer;
    Prediction prediction;
  };

  Localizer localizer;
  PathErrors errors;                ///< over all paths
  std::vector<PathErrors> by_path;  ///< in their order
  std::vector<OfLayer> layers;      ///< of kReadingLayers those that the map has, `alpha` first
  std::vector<CellErrors> cells;
};

/// One for each localizer of the drives, in their order.
std::vector<Validation> validate(std::span<const DrivenPath> paths, std::span<const Localizer> localizers, const ErrorReference& reference);

}  // namespace alignability
