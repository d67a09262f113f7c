// SPDX-License-Identifier: BSD-3-Clause
#include "tests/planner/collision_oracle.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include "tests/costmap/segment_oracle.hpp"

namespace alignability::test {
namespace {

using Box = Eigen::AlignedBox2d;

Box square(const GridGeometry& grid, Cell cell) { return {grid.corner(cell), grid.corner({cell.x + 1, cell.y + 1})}; }

std::vector<Box> obstacles_within(const OccupancyMap& map, const Box& place) {
  const GridGeometry& grid = map.geometry();
  std::vector<Box> obstacles;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Box cell = square(grid, grid.cell_of(i));
    if (!map.is_free(i) && place.intersects(cell)) obstacles.push_back(cell);
  }
  return obstacles;
}

bool leaves(const OccupancyMap& map, const Box& place) {
  return !Box(map.geometry().origin, map.geometry().upper_corner()).contains(place);
}

Box around(const std::vector<Eigen::Vector2d>& corners) {
  Box box;
  for (const Eigen::Vector2d& corner : corners) box.extend(corner);
  return box;
}

bool disk_collides(const OccupancyMap& map, const std::vector<Box>& obstacles, const Eigen::Vector2d& at, double radius) {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(radius);
  return leaves(map, {at - reach, at + reach}) ||
         std::ranges::any_of(obstacles, [&](const Box& cell) { return distance_to_square(at, cell.min(), cell.max()) < radius; });
}

bool polygon_collides(const OccupancyMap& map, const std::vector<Box>& obstacles, const std::vector<Eigen::Vector2d>& corners) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::ring<Point> outline;
  for (const Eigen::Vector2d& corner : corners) bg::append(outline, Point(corner.x(), corner.y()));
  bg::correct(outline);
  const Box place = around(corners);
  return leaves(map, place) || std::ranges::any_of(obstacles, [&](const Box& cell) {
           const bg::model::box<Point> box(Point(cell.min().x(), cell.min().y()), Point(cell.max().x(), cell.max().y()));
           return place.intersects(cell) && bg::intersects(outline, box);
         });
}

}  // namespace

bool collides(const OccupancyMap& map, const std::vector<Eigen::Vector2d>& corners) {
  return polygon_collides(map, obstacles_within(map, around(corners)), corners);
}

std::optional<Pose2> first_collision(const OccupancyMap& map, const Robot& robot, std::span<const Pose2> path) {
  const double reach = circumscribed_radius(robot) + 1e-6;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    Box place(path[i].position());
    place.extend(path[i + 1].position());
    const std::vector<Box> near =
        obstacles_within(map, {place.min() - Eigen::Vector2d::Constant(reach), place.max() + Eigen::Vector2d::Constant(reach)});
    const double length = (path[i + 1].position() - path[i].position()).norm();
    const double turned = std::abs(normalized_angle(path[i + 1].yaw - path[i].yaw));
    const int steps = std::max(1, static_cast<int>((length + turned) / 0.01));
    for (int k = 0; k <= steps; ++k) {
      const Pose2 at = between(path[i], path[i + 1], static_cast<double>(k) / steps);
      const bool hit = robot.footprint.empty() ? disk_collides(map, near, at.position(), robot.radius - 1e-6)
                                               : polygon_collides(map, near, footprint_at(robot, at));
      if (hit) return at;
    }
  }
  return std::nullopt;
}

}  // namespace alignability::test
