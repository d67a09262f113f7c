// SPDX-License-Identifier: BSD-3-Clause
#include "planner/headings.hpp"

namespace alignability {
namespace {

// The direction from one place to another; `same` where they are one.
double heading(const Pose2& from, const Pose2& to, double same) {
  const Eigen::Vector2d step = to.position() - from.position();
  return step == Eigen::Vector2d::Zero() ? same : std::atan2(step.y(), step.x());
}

}  // namespace

std::pair<Pose2, Pose2> facing_ahead(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double yaw = std::atan2(to.y() - from.y(), to.x() - from.x());
  return {{from.x(), from.y(), yaw}, {to.x(), to.y(), yaw}};
}

std::vector<Pose2> looking_ahead(std::vector<Pose2> path, double standing) {
  double ahead = standing;
  for (std::size_t i = 1; i < path.size(); ++i) ahead = heading(path[i - 1], path[i], ahead);
  for (std::size_t i = path.size(); i-- > 0;) {
    if (i + 1 < path.size()) ahead = heading(path[i], path[i + 1], ahead);
    path[i].yaw = ahead;
  }
  return path;
}

std::vector<Pose2> turning_on_the_spot(const std::vector<Pose2>& path) {
  std::vector<Pose2> turning;
  for (const Pose2& pose : path) {
    if (!turning.empty() && turning.back().yaw != pose.yaw) turning.push_back({pose.x, pose.y, turning.back().yaw});
    turning.push_back(pose);
  }
  return turning;
}

}  // namespace alignability
