// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "costmap/error_model.hpp"
#include "costmap/risk_field.hpp"
#include "planner/curve.hpp"

namespace alignability {

/// What is predicted at a place of a path.
struct PredictedError {
  double s = 0.0;      ///< arc length [m]
  double error = 0.0;  ///< 95th percentile [m]
};

/// The error that a model predicts along a path of straight pieces for a robot that is localized at its start as well as it can be, from
/// vertex to vertex and every few centimetres between. O(length).
std::vector<PredictedError> predicted_errors(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model);

/// The greatest of them; the model's least for a path that goes nowhere.
double greatest_predicted_error(std::span<const Pose2> path, const RiskField& risk, const ErrorModel& model);
double greatest_predicted_error(std::span<const Curve> path, const RiskField& risk, const ErrorModel& model);

/// No error above so many metres may be predicted anywhere on a path. Safe to read from many threads.
struct ErrorLimit {
  using State = double;  ///< the error [m]
  struct Change {
    ErrorModel::Change of_error;
    double length = 0.0;  ///< [m]
  };

  ErrorModel model;
  double most = 0.0;  ///< [m], > 0

  State at_start() const { return model.least; }
  /// What a straight way makes of an error; of straight ways only by a risk field that takes no notice of headings.
  Change change(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;
  /// What the error grows to along a straight way; nullopt where it exceeds the limit at some place of it.
  std::optional<State> after(State error, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const RiskField& risk) const;
  /// The same, sooner, of a way whose change is known.
  std::optional<State> after(State error, const Change& change, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                             const RiskField& risk) const;
  /// Along an arc.
  std::optional<State> after(State error, const Arc& arc, const RiskField& risk) const;
  bool is_no_worse(State one, State other, double alike) const { return one <= other + alike * most; }
};

}  // namespace alignability
