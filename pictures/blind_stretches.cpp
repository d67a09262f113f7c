// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/blind_stretches.hpp"

#include <cmath>

namespace alignability::detail {
namespace {

bool is_blind(double alpha, const RiskOptions& risk) {
  return std::isnan(alpha) ? risk.unknown == UnknownPolicy::risky : alpha < risk.alpha_critical;
}

// Where between two points of which one is blind the blind part ends.
double border(const ProfilePoint& a, const ProfilePoint& b, double threshold) {
  const double share = (threshold - a.alpha) / (b.alpha - a.alpha);
  return std::isnan(share) ? 0.5 * (a.s + b.s) : std::lerp(a.s, b.s, share);
}

}  // namespace

std::vector<Stretch> blind_stretches(std::span<const ProfilePoint> profile, const RiskOptions& risk) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const ProfilePoint& a = profile[i - 1];
    const ProfilePoint& b = profile[i];
    const bool begins_blind = is_blind(a.alpha, risk);
    const bool ends_blind = is_blind(b.alpha, risk);
    if (!begins_blind && !ends_blind) continue;
    const double from = begins_blind ? a.s : border(a, b, risk.alpha_critical);
    const double to = ends_blind ? b.s : border(a, b, risk.alpha_critical);
    const bool continues = begins_blind && !stretches.empty() && stretches.back().to == a.s;
    if (continues) {
      stretches.back().to = to;
    } else if (to > from) {
      stretches.push_back({from, to});
    }
  }
  return stretches;
}

std::vector<Eigen::Vector2d> part_of(std::span<const Pose2> poses, double from, double to) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) length += (poses[i].position() - poses[i - 1].position()).norm();
  if (!(length > 0.0)) return {};

  std::vector<Eigen::Vector2d> corners;
  double begin = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::Vector2d a = poses[i - 1].position();
    const Eigen::Vector2d b = poses[i].position();
    const double step = (b - a).norm();
    const double first = std::max(0.0, from * length - begin);
    const double last = std::min(step, to * length - begin);
    begin += step;
    if (first >= last) continue;
    if (corners.empty()) corners.push_back(a + first / step * (b - a));
    corners.push_back(a + last / step * (b - a));
  }
  return corners;
}

}  // namespace alignability::detail
