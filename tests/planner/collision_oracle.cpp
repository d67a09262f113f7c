// SPDX-License-Identifier: BSD-3-Clause
#include "tests/planner/collision_oracle.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include "tests/costmap/segment_oracle.hpp"

namespace alignability::test {

bool collides(const OccupancyMap& map, const std::vector<Eigen::Vector2d>& corners) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::ring<Point> outline;
  for (const Eigen::Vector2d& corner : corners) bg::append(outline, Point(corner.x(), corner.y()));
  bg::correct(outline);
  const GridGeometry& grid = map.geometry();
  const auto box = [](const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    return bg::model::box<Point>(Point(low.x(), low.y()), Point(high.x(), high.y()));
  };
  const auto envelope = bg::return_envelope<bg::model::box<Point>>(outline);
  if (!bg::within(envelope, box(grid.origin, grid.upper_corner()))) return true;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (map.is_free(i)) continue;
    const Cell cell = grid.cell_of(i);
    const Eigen::Vector2d low = grid.corner(cell);
    const Eigen::Vector2d high = grid.corner({cell.x + 1, cell.y + 1});
    const Point& least = envelope.min_corner();
    const Point& most = envelope.max_corner();
    if (low.x() > most.x() || low.y() > most.y() || high.x() < least.x() || high.y() < least.y()) continue;
    if (bg::intersects(outline, box(low, high))) return true;
  }
  return false;
}

std::optional<Pose2> first_collision(const OccupancyMap& map, const Robot& robot, std::span<const Pose2> path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1].position() - path[i].position()).norm();
    const double turned = std::abs(normalized_angle(path[i + 1].yaw - path[i].yaw));
    const int steps = std::max(1, static_cast<int>((length + turned) / 0.01));
    for (int k = 0; k <= steps; ++k) {
      const Pose2 at = between(path[i], path[i + 1], static_cast<double>(k) / steps);
      const bool hit =
          robot.footprint.empty() ? brute_force_distance(map, at.position()) < robot.radius - 1e-6 : collides(map, footprint_at(robot, at));
      if (hit) return at;
    }
  }
  return std::nullopt;
}

}  // namespace alignability::test
