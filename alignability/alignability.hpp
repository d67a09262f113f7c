// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "alignability/plane_segmentation.hpp"
#include "alignability/readings.hpp"
#include "lidar/scan.hpp"
#include "lidar/sensor_rig.hpp"

namespace alignability {

/// About which point the second moment of the normals is taken.
enum class Moment {
  about_origin,  ///< signs of normals do not matter: what mirroring every normal gives (Nobili et al.)
  about_mean,    ///< the textbook PCA, normals turned to the sensor
};

/// What counts as a plane, and how planes become α: Castellano-Quero et al., §III.
struct AlignabilityOptions {
  SegmentationOptions segmentation;
  double plane_threshold = 0.05;  ///< p_th: a segment is a plane when λ_s/λ_l of its points is below
  double min_area = 0.01;         ///< s_th [m²]: a plane is kept when its bounding box is larger
  double min_length = 0.1;        ///< [m] in two dimensions a line is kept when it is longer
  Moment moment = Moment::about_origin;
  std::vector<Reading> readings;  ///< those wanted beside α
  double voxel = 0.08;            ///< side of a cube of Reading::voxel [m]
  double range_stddev = 0.02;     ///< of a return [m]: what robust and information take points to scatter by; > 0
  Eigen::Isometry3d T_base_scan = Eigen::Isometry3d::Identity();  ///< for information: the mount, or none where lidars are joined

  bool wants(Reading reading) const;
};

/// The options with what a sensor's model says of them: least range, noise (where it has any, the largest of several lidars), mount, and
/// whether it sees in two dimensions or three.
AlignabilityOptions for_lidar(AlignabilityOptions options, const SensorRig& sensor);

/// How well a scan constrains alignment.
struct Alignability {
  double alpha = 0.0;                                           ///< λ_c/λ_a in [0,1] (Eq. 1); 0 when no plane is kept
  int dimensions = 3;                                           ///< 2 where planes are lines and normals level
  Eigen::Vector3d eigenvalues = Eigen::Vector3d::Zero();        ///< of the normals' second moment, a >= b >= c; of two a >= b, NaN
  Eigen::Vector3d weakest_direction = Eigen::Vector3d::Zero();  ///< unit, frame of the scan, sign arbitrary; 0 when no plane is kept
  int planes_found = 0;
  int planes_kept = 0;
  std::size_t points = 0;  ///< those that were not dropped
  Readings readings;
};

/// A scan's alignability and how it came about.
struct ScoredScan {
  Alignability alignability;
  /// For each point of the scan the kept plane it belongs to, counted from 0; -1 = none.
  std::vector<int> plane_of_point;
  std::vector<Eigen::Vector3f> normals;  ///< of each point: unit, turned to the sensor; NaN = dropped
  /// Of the eigenvalues, by column; that of the last one, `alignability.dimensions - 1`, is the weakest direction. In two z is the third.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
};

/// Scores scan after scan, keeping its memory: the native engine asks for more only where a scan is larger than all before, or for
/// readings. One a thread; what it has scored before changes nothing. Never throws for the content of a scan: one without planes scores 0.
/// Throws std::invalid_argument for a stride that is not from 1 to kMostStride, or more than 1 with PCL, for fewer neighbours than
/// documented, a reading asked for twice, a voxel or range_stddev that is not greater than 0, and two dimensions with PCL.
class Scorer {
 public:
  explicit Scorer(const AlignabilityOptions& options);
  Scorer(Scorer&&) noexcept;
  Scorer& operator=(Scorer&&) noexcept;
  ~Scorer();

  Alignability alignability(const Scan& scan);
  ScoredScan score(const Scan& scan);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// One scan. Safe to call from many threads.
ScoredScan score(const Scan& scan, const AlignabilityOptions& options);

/// "native" or "pcl".
std::string_view to_string(Engine engine);

/// The options as YAML text, defaults written out.
std::string to_yaml(const AlignabilityOptions& options);

}  // namespace alignability
