// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/floor_plane.hpp"

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lidar/thinning.hpp"

namespace alignability {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr double kMostTilt = std::numbers::pi / 9.0;
constexpr double kThickness = 0.08;  // [m] of a scanned floor, to either side
constexpr double kCube = 0.2;        // [m] so that dense places do not outvote wide ones
constexpr int kPlanes = 5;           // that may lie one above the other
constexpr std::size_t kLeastPoints = 50;

struct Plane {
  Eigen::Hyperplane<double, 3> plane;  // its normal up
  double height = 0.0;                 // the mean of its points' z
  std::size_t points = 0;
};

// The plane with the most points among those near level; takes them from the rest.
std::optional<Plane> take_largest(const Points::Ptr& rest) {
  pcl::SACSegmentation<pcl::PointXYZ> search;
  search.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
  search.setMethodType(pcl::SAC_RANSAC);
  search.setAxis(Eigen::Vector3f::UnitZ());
  search.setEpsAngle(kMostTilt);
  search.setDistanceThreshold(kThickness);
  search.setMaxIterations(2000);
  search.setOptimizeCoefficients(true);
  search.setInputCloud(rest);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients found;
  search.segment(inliers, found);
  if (inliers.indices.size() < kLeastPoints) return std::nullopt;
  Eigen::Vector4d plane(found.values[0], found.values[1], found.values[2], found.values[3]);
  plane *= (plane.z() < 0.0 ? -1.0 : 1.0) / plane.head<3>().norm();
  Plane result{.plane = Eigen::Hyperplane<double, 3>(plane.head<3>(), plane.w()), .points = inliers.indices.size()};
  std::vector<char> is_taken(rest->size());
  for (const int i : inliers.indices) {
    is_taken[static_cast<std::size_t>(i)] = 1;
    result.height += (*rest)[static_cast<std::size_t>(i)].z / static_cast<double>(inliers.indices.size());
  }
  Points left;
  for (std::size_t i = 0; i < rest->size(); ++i) {
    if (is_taken[i] == 0) left.push_back((*rest)[i]);
  }
  *rest = left;
  return result;
}

// Through the points near the plane, least squares; the feet of walls, which stand on one side of it, are cut off by the scatter of the
// rest.
Eigen::Hyperplane<double, 3> refined(Eigen::Hyperplane<double, 3> plane, std::span<const Eigen::Vector3f> points) {
  constexpr double kLeastScatter = 0.005;  // [m]
  double reach = kThickness;
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<double> off;
    Eigen::Matrix3Xd near(3, static_cast<Eigen::Index>(points.size()));
    for (const Eigen::Vector3f& point : points) {
      const double distance = plane.absDistance(point.cast<double>());
      if (distance > reach) continue;
      near.col(static_cast<Eigen::Index>(off.size())) = point.cast<double>();
      off.push_back(distance);
    }
    if (off.size() < kLeastPoints) break;
    near.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(off.size()));
    const Eigen::Vector3d mean = near.rowwise().mean();
    const Eigen::Matrix3Xd centred = near.colwise() - mean;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred * centred.transpose());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    plane = Eigen::Hyperplane<double, 3>(normal.z() < 0.0 ? -normal : normal, mean);
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::ranges::nth_element(off, middle);
    reach = std::clamp(3.0 * *middle, kLeastScatter, kThickness);
  }
  return plane;
}

Eigen::Hyperplane<double, 3> floor_of(std::span<const Eigen::Vector3f> points) {
  const std::vector<Eigen::Vector3f> thin = thinned(points, kCube);
  const Points::Ptr rest(new Points);
  for (const Eigen::Vector3f& point : thin) rest->push_back({point.x(), point.y(), point.z()});
  std::optional<Plane> lowest;
  std::size_t most = 0;
  for (int i = 0; i < kPlanes && rest->size() >= kLeastPoints; ++i) {
    const std::optional<Plane> plane = take_largest(rest);
    if (!plane) break;
    most = std::max(most, plane->points);
    if (4 * plane->points >= most && (!lowest || plane->height < lowest->height)) lowest = plane;
  }
  if (!lowest) throw std::invalid_argument("no plane among its points is near level, so there is no floor to level it by");
  return refined(lowest->plane, thin);
}

}  // namespace

Eigen::Isometry3d leveled(std::span<const Eigen::Vector3f> points) {
  const Eigen::Hyperplane<double, 3> floor = floor_of(points);
  const Eigen::Vector3d z = floor.normal();
  Eigen::Matrix3d axes;  // of `map` in the points' frame
  axes.col(1) = z.cross(Eigen::Vector3d::UnitX()).normalized();
  axes.col(0) = axes.col(1).cross(z);
  axes.col(2) = z;
  const Eigen::Vector3d origin(0.0, 0.0, -floor.offset() / z.z());
  Eigen::Isometry3d T_map_points = Eigen::Isometry3d::Identity();
  T_map_points.linear() = axes.transpose();
  T_map_points.translation() = -(axes.transpose() * origin);
  return T_map_points;
}

}  // namespace alignability
