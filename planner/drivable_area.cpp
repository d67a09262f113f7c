// SPDX-License-Identifier: BSD-3-Clause
#include "planner/drivable_area.hpp"

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace alignability {

DrivableArea::DrivableArea(std::shared_ptr<const ClearanceMap> clearance, std::shared_ptr<const RiskField> risk, const Robot& robot)
    : clearance_(std::move(clearance)), risk_(std::move(risk)), robot_(robot) {}

bool DrivableArea::contains(const Pose2& pose) const {
  return clearance_->is_clear(pose.position(), robot_.radius) && risk_->is_drivable(pose.position());
}

bool DrivableArea::contains(const Pose2& from, const Pose2& to) const {
  return clearance_->is_clear(from.position(), to.position(), robot_.radius) && risk_->is_drivable(from.position(), to.position());
}

double DrivableArea::clearance(const Pose2& pose) const { return clearance_->distance(pose.position()) - robot_.radius; }

bool DrivableArea::may_connect(const Pose2& from, const Pose2& to, double tolerance) const {
  const GridGeometry& grid = geometry();
  const auto start = grid.cell_near(from.position());
  if (!start) return false;
  const double reach = grid.resolution / std::numbers::sqrt2 + 1e-6 * grid.resolution;
  std::vector<bool> seen(grid.size(), false);
  std::vector<Cell> front{*start};
  seen[grid.index(*start)] = true;
  while (!front.empty()) {
    const Cell at = front.back();
    front.pop_back();
    const Eigen::AlignedBox2d square(grid.corner(at), grid.corner({at.x + 1, at.y + 1}));
    if (square.exteriorDistance(to.position()) <= tolerance) return true;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{at.x + dx, at.y + dy};
        if (!grid.contains(next) || seen[grid.index(next)] || clearance_->distance_at(next) + reach < robot_.radius) continue;
        seen[grid.index(next)] = true;
        front.push_back(next);
      }
    }
  }
  return false;
}

}  // namespace alignability
