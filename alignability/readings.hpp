// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string_view>

namespace alignability {

/// What else a scan says of how well it can be aligned, beside the paper's α.
enum class Reading {
  centred,      ///< α of the textbook PCA, the normals' mean subtracted
  voxel,        ///< α about the origin of the scan thinned to one point, the mean, in each cube, as Nobili et al. do with 8 cm
  robust,       ///< α about the origin of the planes' own normals, each as often as it has points: without what noise does to the normals
  information,  ///< how narrowly aligning the planes' points holds x, y and yaw of the robot on its floor
};

/// "centred", "voxel", "robust", "information".
std::string_view to_string(Reading reading);

/// The Fisher information of point-to-plane alignment: J = Σ j jᵀ/σ² over the points p of all planes with their plane's own normal n, j =
/// (n_x, n_y, (p × n)_z), σ the standard deviation of a point's distance to its plane, all in the robot's frame. Its inverse is what the
/// covariance of an alignment is at best (Cramér and Rao), errors of points independent.
struct PlanarInformation {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();             ///< of x, y [1/m²] and yaw [1/rad²]
  double least = 0.0;                                           ///< along the weakest direction, yaw unknown too [1/m²]
  Eigen::Vector2d weakest_direction = Eigen::Vector2d::Zero();  ///< unit, sign arbitrary; 0 where nothing holds any
  double yaw = 0.0;                                             ///< the place unknown too [1/rad²]
};

/// NaN where a reading was not asked for; 0 without planes.
struct Readings {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double centred = kNone;
  double voxel = kNone;
  double robust = kNone;
  PlanarInformation information{
      .matrix = Eigen::Matrix3d::Constant(kNone), .least = kNone, .weakest_direction = Eigen::Vector2d::Constant(kNone), .yaw = kNone};
};

/// NaN where it was not asked for; of the information the least.
double value_of(Reading reading, const Readings& readings);

}  // namespace alignability
