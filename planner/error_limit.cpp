// SPDX-License-Identifier: BSD-3-Clause
#include "planner/error_limit.hpp"

#include <algorithm>
#include <cmath>

namespace alignability {
namespace {

constexpr double kStep = 0.05;  // [m], on which α is taken for one

// Calls `visit(α, metres)` for each step of a way, until it returns false. `at(share)`: the pose after that share of it.
template <typename At, typename Visit>
void walk(double length, const RiskField& risk, At at, Visit visit) {
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  for (int i = 0; i < steps; ++i) {
    const Pose2 middle = at((i + 0.5) / steps);
    if (!visit(risk.alpha(middle.x, middle.y, middle.yaw), length / steps)) return;
  }
}

template <typename Visit>
void walk(const Pose2& from, const Pose2& to, const RiskField& risk, Visit visit) {
  walk((to.position() - from.position()).norm(), risk, [&](double share) { return between(from, to, share); }, visit);
}

template <typename Visit>
void walk(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk, Visit visit) {
  walk(Pose2{from.x(), from.y(), 0.0}, Pose2{to.x(), to.y(), 0.0}, risk, visit);
}

template <typename Visit>
void walk(const Arc& arc, const RiskField& risk, Visit visit) {
  walk(
      arc.length(), risk, [&](double share) { return arc.at(share * arc.length()); }, visit);
}

// After a straight way, from and to, or an arc.
template <typename... Way>
std::optional<double> after_way(const ErrorLimit& limit, double error, const RiskField& risk, const Way&... way) {
  walk(way..., risk, [&](double alpha, double metres) { return (error = limit.model.advanced(error, alpha, metres)) <= limit.most; });
  return error <= limit.most ? std::optional(error) : std::nullopt;
}

}  // namespace

std::vector<PredictedError> predicted_errors(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model) {
  std::vector<PredictedError> along;
  if (path.empty()) return along;
  along.push_back({0.0, model.least});
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i - 1].position() == path[i].position()) continue;
    walk(path[i - 1], path[i], risk, [&](double alpha, double metres) {
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

double greatest_predicted_error(std::span<const Curve> path, const RiskField& risk, const ErrorModel& model) {
  double error = model.least;
  double most = error;
  for (const Curve& curve : path) {
    for (const Arc& arc : curve.arcs()) {
      walk(arc, risk, [&](double alpha, double metres) {
        error = model.advanced(error, alpha, metres);
        most = std::max(most, error);
        return true;
      });
    }
  }
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
  return after_way(*this, error, risk, from, to);
}

std::optional<double> ErrorLimit::after(double error, const Arc& arc, const RiskField& risk) const {
  return after_way(*this, error, risk, arc);
}

std::optional<double> ErrorLimit::after(double error, const Change& change, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                        const RiskField& risk) const {
  // Nowhere does it grow faster.
  if (error + model.growth * change.length <= most) return std::max(model.least, change.of_error.of(error));
  return after(error, from, to, risk);
}

}  // namespace alignability
