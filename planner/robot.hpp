// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

/// The robot's outline in the plane: a disk around `base_link`, or a polygon.
struct Robot {
  double radius = 0.0;                       ///< [m], > 0; without effect where there is a footprint
  std::vector<Eigen::Vector2d> footprint{};  ///< corners in `base_link` in order [m]; a simple polygon, convex or not; empty: the disk
};

/// The radius of the largest disk around `base_link` within the outline [m]; 0 where `base_link` lies outside of it.
double inscribed_radius(const Robot& robot);
/// The radius of the smallest disk around `base_link` that holds the outline [m].
double circumscribed_radius(const Robot& robot);

/// What is wrong with a footprint, in a sentence: too few corners, one farther than 1000 m or not finite, edges that cross or touch;
/// nullopt for a simple polygon.
std::optional<std::string> fault_of_footprint(const std::vector<Eigen::Vector2d>& corners);

/// The corners in `map` when `base_link` is at a pose.
std::vector<Eigen::Vector2d> footprint_at(const Robot& robot, const Pose2& pose);

}  // namespace alignability
