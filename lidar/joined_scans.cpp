// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/joined_scans.hpp"

#include <limits>
#include <string>

#include "core/input_error.hpp"
#include "core/range.hpp"
#include "lidar/point_table.hpp"
#include "lidar/thinning.hpp"

namespace alignability {
namespace {

// Cubes that several scans saw are thinned again once there are so many times as many points as after the last time.
constexpr std::size_t kGrowth = 4;

// Floats round to 4 mm there.
constexpr double kFarthestFromOrigin = 1 << 16;

std::vector<Eigen::Vector3f> points_in_map(const PosedScan& scan, const JoinOptions& options) {
  const double away = scan.T_map_lidar.translation().norm();
  if (away > kFarthestFromOrigin) {
    throw InputError(scan.file, "was taken " + fixed_text(away, 0) +
                                    " m from the origin of map, where points are no longer told apart; "
                                    "shift the trajectory to an origin on the site");
  }
  const auto square = [](double range) { return static_cast<float>(range * range); };
  const float nearest = square(options.range_min);
  const float farthest = options.range_max ? square(*options.range_max) : std::numeric_limits<float>::infinity();
  const Scan seen = scan_of(scan);
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : seen.points) {
    const float distance = point.squaredNorm();
    if (distance >= nearest && distance <= farthest) points.push_back((scan.T_map_lidar * point.cast<double>()).cast<float>());
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector3f> joined(std::span<const PosedScan> scans, const JoinOptions& options) {
  std::vector<Eigen::Vector3f> cloud;
  std::size_t after_thinning = 0;
  const auto thin = [&] {
    if (options.thinning) cloud = thinned(cloud, *options.thinning);
    after_thinning = cloud.size();
  };
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (options.stop.stop_requested()) throw Interrupted();
    if (options.progress) options.progress({i, scans.size()});
    const std::vector<Eigen::Vector3f> points = points_in_map(scans[i], options);
    cloud.insert(cloud.end(), points.begin(), points.end());
    if (options.thinning && cloud.size() > kGrowth * after_thinning) thin();
    if (cloud.size() > detail::kMostPoints) {
      throw InputError(scans[i].file, "is one scan too many: joined, they have more than " + std::to_string(detail::kMostPoints) +
                                          " points; thin them more coarsely, or join fewer");
    }
  }
  thin();
  if (options.progress) options.progress({scans.size(), scans.size()});
  return cloud;
}

}  // namespace alignability
