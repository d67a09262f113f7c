// SPDX-License-Identifier: BSD-3-Clause
#include "planner/robot.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <cmath>

namespace alignability {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Ring = bg::model::ring<Point>;

// Closed, and turned the way Boost wants it.
Ring ring_of(const std::vector<Eigen::Vector2d>& corners) {
  Ring ring;
  for (const Eigen::Vector2d& corner : corners) bg::append(ring, Point(corner.x(), corner.y()));
  bg::correct(ring);
  return ring;
}

// Beyond some 1e15 times the shortest edge Boost.Geometry's integers end.
constexpr double kFarthestCorner = 1000.0;

}  // namespace

double inscribed_radius(const Robot& robot) {
  if (robot.footprint.empty()) return robot.radius;
  const Ring ring = ring_of(robot.footprint);
  const Point base_link(0.0, 0.0);
  if (!bg::within(base_link, ring)) return 0.0;
  return bg::distance(base_link, bg::model::linestring<Point>(ring.begin(), ring.end()));
}

double circumscribed_radius(const Robot& robot) {
  double radius = robot.footprint.empty() ? robot.radius : 0.0;
  for (const Eigen::Vector2d& corner : robot.footprint) radius = std::max(radius, corner.norm());
  return radius;
}

std::optional<std::string> fault_of_footprint(const std::vector<Eigen::Vector2d>& corners) {
  if (corners.size() < 3) return "a footprint needs at least 3 corners";
  if (!std::ranges::all_of(corners, [](const Eigen::Vector2d& corner) { return corner.allFinite(); }))
    return "corners must be finite numbers";
  if (!std::ranges::all_of(corners, [](const Eigen::Vector2d& corner) { return corner.cwiseAbs().maxCoeff() <= kFarthestCorner; }))
    return "corners must be within 1000 m of base_link";
  bg::validity_failure_type failure{};
  if (bg::is_valid(ring_of(corners), failure)) return std::nullopt;
  switch (failure) {
    case bg::failure_self_intersections:
      return "the footprint's edges must not cross or touch";
    case bg::failure_spikes:
      return "the footprint must not fold back upon itself";
    default:
      return "the footprint must be a polygon with an area";
  }
}

std::vector<Eigen::Vector2d> footprint_at(const Robot& robot, const Pose2& pose) {
  const Eigen::Rotation2Dd turn(pose.yaw);
  std::vector<Eigen::Vector2d> corners;
  corners.reserve(robot.footprint.size());
  for (const Eigen::Vector2d& corner : robot.footprint) corners.emplace_back(pose.position() + turn * corner);
  return corners;
}

}  // namespace alignability
