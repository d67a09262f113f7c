// SPDX-License-Identifier: BSD-3-Clause
#include "planner/footprint_sweep.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace alignability {
namespace {

constexpr double kFinest = 1e-3;  // [cells]

Eigen::Isometry2d T_map_base(const Pose2& pose) { return Eigen::Translation2d(pose.position()) * Eigen::Rotation2Dd(pose.yaw); }

}  // namespace

FootprintSweep::FootprintSweep(std::shared_ptr<const ClearanceMap> map, const std::vector<Eigen::Vector2d>& footprint)
    : map_(std::move(map)) {
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Eigen::Vector2d& from = footprint[i];
    const Eigen::Vector2d& to = footprint[(i + 1) % footprint.size()];
    edges_.push_back({from, to, std::max(from.norm(), to.norm())});
    reach_ = std::max(reach_, from.norm());
    longest_edge_ = std::max(longest_edge_, (to - from).norm());
  }
}

bool FootprintSweep::is_clear(const Pose2& pose) const { return edges_are_clear(pose, pose) && inside_is_free(pose); }

// What the polygon covers on the way, it covers at the start or its outline sweeps over.
bool FootprintSweep::is_clear(const Pose2& from, const Pose2& to) const { return is_clear(from) && edges_sweep_clear(from, to); }

bool FootprintSweep::edges_sweep_clear(const Pose2& from, const Pose2& to) const {
  if (map_->is_clear(from.position(), to.position(), reach_) || edges_are_clear(from, to)) return true;
  const double turned = std::abs(normalized_angle(to.yaw - from.yaw));
  // What a hull of an edge's four ends has too much: the bulge, and a quarter of what the edge twists by on its way.
  const double excess = reach_ * turned * turned / 8.0 + longest_edge_ * turned / 4.0;
  if (excess <= kFinest * map_->geometry().resolution) return false;
  const Pose2 middle = between(from, to, 0.5);
  return edges_are_clear(middle, middle) && edges_sweep_clear(from, middle) && edges_sweep_clear(middle, to);
}

// Each edge stays within the hull of its ends before and after, but for the bulge of the arcs: a point at distance r from base_link
// leaves the chord by at most r·turned²/8.
bool FootprintSweep::edges_are_clear(const Pose2& from, const Pose2& to) const {
  const Eigen::Isometry2d begin = T_map_base(from);
  const Eigen::Isometry2d end = T_map_base(to);
  const double turned = normalized_angle(to.yaw - from.yaw);
  return std::ranges::all_of(edges_, [&](const Edge& edge) {
    const std::array<Eigen::Vector2d, 4> hull{begin * edge.from, begin * edge.to, end * edge.from, end * edge.to};
    return map_->is_clear(hull, edge.reach * turned * turned / 8.0);
  });
}

bool FootprintSweep::is_clear(const Arc& arc) const {
  if (arc.curvature == 0.0) return is_clear(arc.start, arc.end());
  return is_clear(arc.start) && edges_sweep_clear(arc);
}

bool FootprintSweep::edges_sweep_clear(const Arc& arc) const {
  if (map_->is_clear(arc.start.position(), arc.end().position(), reach_ + arc.bulge()) || edges_are_clear(arc)) return true;
  const double turned = std::abs(arc.turn());
  const double excess = (reach_ + 1.0 / std::abs(arc.curvature)) * turned * turned / 8.0 + longest_edge_ * turned / 4.0;
  if (excess <= kFinest * map_->geometry().resolution) return false;
  const double middle = 0.5 * arc.length();
  const Pose2 halfway = arc.at(middle);
  return edges_are_clear(halfway, halfway) && edges_sweep_clear(arc.piece(0.0, middle)) &&
         edges_sweep_clear(arc.piece(middle, arc.length()));
}

// As where it moves straight: every point turns about the arc's centre, along an arc about that.
bool FootprintSweep::edges_are_clear(const Arc& arc) const {
  const Eigen::Isometry2d begin = T_map_base(arc.start);
  const Eigen::Isometry2d end = T_map_base(arc.end());
  const Eigen::Vector2d center(0.0, 1.0 / arc.curvature);
  return std::ranges::all_of(edges_, [&](const Edge& edge) {
    const std::array<Eigen::Vector2d, 4> hull{begin * edge.from, begin * edge.to, end * edge.from, end * edge.to};
    const double farthest = std::max((edge.from - center).norm(), (edge.to - center).norm());
    return map_->is_clear(hull, farthest * arc.turn() * arc.turn() / 8.0);
  });
}

// Holds only where the edges are clear: every other cell then lies wholly inside or wholly outside, and its centre tells which.
bool FootprintSweep::inside_is_free(const Pose2& pose) const {
  const GridGeometry& grid = map_->geometry();
  const Eigen::Isometry2d T_map = T_map_base(pose);
  const Eigen::Isometry2d T_base = T_map.inverse();
  Eigen::AlignedBox2d box;
  for (const Edge& edge : edges_) box.extend(T_map * edge.from);
  const auto low = grid.cell_near(box.min());
  const auto high = grid.cell_near(box.max());
  if (!low || !high) return false;
  for (int row = low->y; row <= high->y; ++row) {
    for (int column = low->x; column <= high->x; ++column) {
      if (map_->is_free({column, row})) continue;
      const Eigen::Vector2d center = T_base * grid.center({column, row});
      bool inside = false;
      for (const Edge& edge : edges_) {
        const Eigen::Vector2d step = edge.to - edge.from;
        const bool crosses = (edge.from.y() > center.y()) != (edge.to.y() > center.y());
        if (crosses && center.x() < edge.from.x() + step.x() * (center.y() - edge.from.y()) / step.y()) inside = !inside;
      }
      if (inside) return false;
    }
  }
  return true;
}

double FootprintSweep::clearance(const Pose2& pose) const {
  if (!is_clear(pose)) return 0.0;
  const Eigen::Isometry2d T_map = T_map_base(pose);
  // The nearest edge's distance: the largest radius of a disk that gets along all of them.
  double clear = 0.0;
  double blocked = map_->distance(T_map * edges_.front().from);
  while (blocked - clear > 1e-9 * map_->geometry().resolution) {
    const double radius = 0.5 * (clear + blocked);
    const bool fits =
        std::ranges::all_of(edges_, [&](const Edge& edge) { return map_->is_clear(T_map * edge.from, T_map * edge.to, radius); });
    (fits ? clear : blocked) = radius;
  }
  return clear;
}

}  // namespace alignability
