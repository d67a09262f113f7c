// SPDX-License-Identifier: BSD-3-Clause
#include "planner/error_limit.hpp"

#include <algorithm>
#include <cmath>

namespace alignability {
namespace {

constexpr double kStep = 0.05;  // [m], on which α is taken for one

// Calls `visit(α, metres)` for each step of a straight way, until it returns false.
template <typename Visit>
void walk(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk, Visit visit) {
  const double length = (to - from).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d middle = from + (i + 0.5) / steps * (to - from);
    if (!visit(risk.alpha(middle.x(), middle.y(), 0.0), length / steps)) return;
  }
}

}  // namespace

std::vector<PredictedError> predicted_errors(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model) {
  std::vector<PredictedError> along;
  if (path.empty()) return along;
  along.push_back({0.0, model.least});
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d from = path[i - 1].position();
    const Eigen::Vector2d to = path[i].position();
    if (from == to) continue;
    walk(from, to, risk, [&](double alpha, double metres) {
      along.push_back({along.back().s + metres, model.advanced(along.back().error, alpha, metres)});
      return true;
    });
  }
  return along;
}

double greatest_predicted_error(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model) {
  double most = model.least;
  for (const PredictedError& at : predicted_errors(path, risk, model)) most = std::max(most, at.error);
  return most;
}

ErrorLimit::Change ErrorLimit::change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const {
  Change change{{}, (to - from).norm()};
  walk(from, to, risk, [&](double alpha, double metres) {
    change.of_error = change.of_error.then(model.change(alpha, metres));
    return true;
  });
  return change;
}

std::optional<double> ErrorLimit::after(double error, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const {
  bool kept = true;
  walk(from, to, risk, [&](double alpha, double metres) {
    error = model.advanced(error, alpha, metres);
    return kept = error <= most;
  });
  return kept ? std::optional(error) : std::nullopt;
}

std::optional<double> ErrorLimit::after(double error, const Change& change, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                        const RiskField& risk) const {
  // Nowhere does it grow faster.
  if (error + model.growth * change.length <= most) return std::max(model.least, change.of_error.of(error));
  return after(error, from, to, risk);
}

}  // namespace alignability
