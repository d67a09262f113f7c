// SPDX-License-Identifier: BSD-3-Clause
#include "planner/error_limit.hpp"

#include <algorithm>
#include <cmath>

namespace alignability {
namespace {

constexpr double kStep = 0.05;  // [m], on which α is taken for one

// Calls `visit(share of the way, error there)` at the end of every step, until it returns false.
template <typename Visit>
void walk(double error, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk, const ErrorModel& model,
          Visit visit) {
  const double length = (to - from).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d middle = from + (i + 0.5) / steps * (to - from);
    error = model.advanced(error, risk.alpha(middle.x(), middle.y(), 0.0), length / steps);
    if (!visit(static_cast<double>(i + 1) / steps, error)) return;
  }
}

}  // namespace

std::vector<PredictedError> predicted_errors(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model) {
  std::vector<PredictedError> along;
  if (path.empty()) return along;
  along.push_back({0.0, model.least});
  double begin = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d from = path[i - 1].position();
    const Eigen::Vector2d to = path[i].position();
    const double length = (to - from).norm();
    if (length == 0.0) continue;
    walk(along.back().error, from, to, risk, model, [&](double share, double error) {
      along.push_back({begin + share * length, error});
      return true;
    });
    begin += length;
  }
  return along;
}

double greatest_predicted_error(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model) {
  double most = model.least;
  for (const PredictedError& at : predicted_errors(path, risk, model)) most = std::max(most, at.error);
  return most;
}

std::optional<double> ErrorLimit::after(double error, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const {
  bool kept = true;
  walk(error, from, to, risk, model, [&](double, double at) {
    error = at;
    return kept = at <= most;
  });
  return kept ? std::optional(error) : std::nullopt;
}

}  // namespace alignability
