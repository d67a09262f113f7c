// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "localization/cube_index.hpp"

namespace alignability {

struct PlaneMapOptions {
  /// How far from a place its nearest point may be [m]: the farthest from its surfaces that a scan may lie when it is first matched.
  double reach = 0.6;
  double neighbourhood = 0.2;  ///< radius [m] around a point, at most the reach, of the points that its normal is taken from
  int min_neighbours = 6;      ///< with fewer, itself among them, a point has no plane, >= 4
  /// A neighbourhood with eigenvalues a ≥ b ≥ c of its covariance is a plane where c is at most this share of b, so that it is thin, and b
  /// at least this share of a, so that it is no line. In (0, 1).
  double flatness = 0.05;
};

/// A point of a map and the unit normal of the surface there, to either side of it.
struct Surface {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

/// The points of a map with the planes that their neighbours lie in. Immutable.
class PlaneMap {
 public:
  /// Of those points that are finite. O(points · points of a neighbourhood). Throws std::invalid_argument for options out of range.
  PlaneMap(std::span<const Eigen::Vector3f> points, const PlaneMapOptions& options);

  /// The point nearest to a place; nullptr where there is none within reach, or where the nearest lies in no plane: at an edge, in clutter.
  const Surface* nearest(const Eigen::Vector3d& place) const;

 private:
  struct Block {
    std::uint32_t begin, end;
  };

  std::span<const Surface> in(const Cube& cube) const;
  template <typename Visit>
  void visit_near(const Eigen::Vector3d& place, float within2, Visit visit) const;
  Eigen::Vector3f normal_at(const Eigen::Vector3f& point, const PlaneMapOptions& options) const;

  double reach_;
  std::vector<Surface> surfaces_;  // by cubes as large as the reach; the normal is zero where there is no plane
  CubeIndex index_;
  std::vector<Block> blocks_;  // of the cubes, as numbered
};

}  // namespace alignability
