// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/arc.hpp"
#include "core/pose.hpp"
#include "costmap/clearance_map.hpp"

namespace alignability {

/// A polygon that moves over a map. Immutable, safe to use from many threads.
class FootprintSweep {
 public:
  /// A simple polygon by its corners in `base_link` [m], at least three.
  FootprintSweep(std::shared_ptr<const ClearanceMap> map, const std::vector<Eigen::Vector2d>& footprint);

  /// Whether the polygon, its inside included, lies on free cells alone.
  bool is_clear(const Pose2& pose) const;
  /// Whether it does all along the straight way, on which it turns evenly the shorter way around. No sampling: exact for a motion
  /// without turning; one that turns is refused where it comes nearer than a thousandth of a cell, never allowed where it collides.
  bool is_clear(const Pose2& from, const Pose2& to) const;
  /// Whether it does all along an arc, likewise.
  bool is_clear(const Arc& arc) const;

  /// The least distance [m] from the outline to a cell that is not free, to a billionth of a cell; 0 where it collides.
  double clearance(const Pose2& pose) const;

 private:
  struct Edge {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
    double reach;  // of its farther end from base_link [m]
  };

  bool edges_are_clear(const Pose2& from, const Pose2& to) const;
  bool edges_sweep_clear(const Pose2& from, const Pose2& to) const;
  bool edges_are_clear(const Arc& arc) const;
  bool edges_sweep_clear(const Arc& arc) const;
  bool inside_is_free(const Pose2& pose) const;

  std::shared_ptr<const ClearanceMap> map_;
  std::vector<Edge> edges_;
  double reach_ = 0.0;         // of the farthest corner from base_link [m]
  double longest_edge_ = 0.0;  // [m]
};

}  // namespace alignability
