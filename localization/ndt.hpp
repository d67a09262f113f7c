// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "localization/cube_index.hpp"

namespace alignability {

enum class NdtCells {
  cubes,
  squares,  ///< of the plane, whatever the points' z, which counts as 0: for the scans of level lidars
};

struct NdtOptions {
  double cell = 0.4;         ///< side of a cell [m]
  int min_points = 6;        ///< a cell with fewer is empty, >= 4
  double flattest = 1.0e-3;  ///< an eigenvalue is at least this share of the largest
  NdtCells shape = NdtCells::cubes;
};

/// The points of one cell as a Gaussian.
struct NdtCell {
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

/// A normal distributions transform: cubes, or squares, stacked from the origin, each with the Gaussian of the points that it holds (Biber
/// and Straßer 2003; Magnusson 2009). Immutable.
class Ndt {
 public:
  /// Of those points that are finite. O(points). Throws std::invalid_argument for options out of range.
  Ndt(std::span<const Eigen::Vector3f> points, const NdtOptions& options);

  /// The Gaussian of the cube that holds a place; nullptr where that is empty.
  const NdtCell* find(const Eigen::Vector3d& place) const;
  /// In the order in which the points first came upon them.
  std::span<const NdtCell> cells() const { return cells_; }

 private:
  Eigen::Vector3d counted(const Eigen::Vector3d& place) const;

  NdtCells shape_;
  double cell_;
  std::vector<NdtCell> cells_;
  CubeIndex index_;
};

}  // namespace alignability
