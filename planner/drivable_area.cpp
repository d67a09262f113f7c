// SPDX-License-Identifier: BSD-3-Clause
#include "planner/drivable_area.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/range.hpp"

namespace alignability {
namespace {

const Robot& checked(const Robot& robot) {
  if (robot.footprint.empty()) {
    if (!kPositive.contains(robot.radius)) throw std::invalid_argument("a robot needs a radius greater than 0 or a footprint");
  } else if (const auto fault = fault_of_footprint(robot.footprint)) {
    throw std::invalid_argument(*fault);
  }
  return robot;
}

}  // namespace

DrivableArea::DrivableArea(std::shared_ptr<const ClearanceMap> clearance, std::shared_ptr<const RiskField> risk, const Robot& robot)
    : clearance_(std::move(clearance)),
      risk_(std::move(risk)),
      inscribed_radius_(alignability::inscribed_radius(checked(robot))),
      circumscribed_radius_(alignability::circumscribed_radius(robot)) {
  if (!robot.footprint.empty()) sweep_.emplace(clearance_, robot.footprint);
}

bool DrivableArea::contains(const Pose2& pose) const {
  const Eigen::Vector2d at = pose.position();
  if (!clearance_->is_clear(at, inscribed_radius_) || !risk_->is_drivable_at(pose)) return false;
  return !sweep_ || clearance_->is_clear(at, circumscribed_radius_) || sweep_->is_clear(pose);
}

bool DrivableArea::contains(const Pose2& from, const Pose2& to) const {
  const Eigen::Vector2d a = from.position();
  const Eigen::Vector2d b = to.position();
  if (!clearance_->is_clear(a, b, inscribed_radius_) || !risk_->is_drivable_along(from, to)) return false;
  return !sweep_ || clearance_->is_clear(a, b, circumscribed_radius_) || sweep_->is_clear(from, to);
}

bool DrivableArea::contains_disk(const Eigen::Vector2d& place) const {
  return clearance_->is_clear(place, inscribed_radius_) && risk_->is_drivable(place);
}

bool DrivableArea::contains(const Arc& arc) const {
  if (!clearance_->is_clear(arc, inscribed_radius_) || !risk_->is_drivable(arc)) return false;
  return !sweep_ || clearance_->is_clear(arc, circumscribed_radius_) || sweep_->is_clear(arc);
}

bool DrivableArea::contains(const Curve& curve) const {
  if (curve.arcs().empty()) return contains(curve.start());
  return std::ranges::all_of(curve.arcs(), [&](const Arc& arc) { return contains(arc); });
}

double DrivableArea::clearance(const Pose2& pose) const {
  return sweep_ ? sweep_->clearance(pose) : clearance_->distance(pose.position()) - inscribed_radius_;
}

bool DrivableArea::may_connect(const Pose2& from, const Pose2& to, double tolerance, const StopTest& stop) const {
  const GridGeometry& grid = geometry();
  const auto start = grid.cell_near(from.position());
  if (!start) return false;
  const double reach = grid.resolution / std::numbers::sqrt2 + 1e-6 * grid.resolution;
  std::vector<bool> seen(grid.size(), false);
  std::vector<Cell> front{*start};
  seen[grid.index(*start)] = true;
  constexpr std::size_t kBetweenLooks = 1024;
  for (std::size_t visited = 0; !front.empty(); ++visited) {
    if (visited % kBetweenLooks == 0) stop_if(stop);
    const Cell at = front.back();
    front.pop_back();
    const Eigen::AlignedBox2d square(grid.corner(at), grid.corner({at.x + 1, at.y + 1}));
    if (square.exteriorDistance(to.position()) <= tolerance) return true;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{at.x + dx, at.y + dy};
        if (!grid.contains(next) || seen[grid.index(next)] || clearance_->distance_at(next) + reach < inscribed_radius_) continue;
        seen[grid.index(next)] = true;
        front.push_back(next);
      }
    }
  }
  return false;
}

}  // namespace alignability
