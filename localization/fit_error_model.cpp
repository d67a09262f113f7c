// SPDX-License-Identifier: BSD-3-Clause
#include "localization/fit_error_model.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace alignability {
namespace {

constexpr double kStep = 0.5;      // [m]
constexpr double kSettling = 2.0;  // the first metres, where the guess of the start is still being mended
constexpr double kLeastMetres = 4.0;
constexpr double kPoor[] = {0.02, 0.05, 0.1, 0.15, 0.2};
constexpr double kRich[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8};

// A place of a path: the error there, and the alignability on the way to the next place.
struct Station {
  double s;
  double p95;
  double alpha;
};

using Stations = std::vector<Station>;

double alpha_near(const Drive& drive, double s, const RiskField& risk) {
  const auto at = std::ranges::lower_bound(drive, s, {}, [](const DriveSample& sample) { return sample.truth.s; });
  const Pose2& pose = at == drive.end() ? drive.back().truth.pose : at->truth.pose;
  return risk.alpha(pose.x, pose.y, pose.yaw);
}

Stations stations_of(const DrivenPath& path, std::size_t localizer, const RiskField& risk) {
  Stations stations;
  for (const ErrorAlong& at : errors_along(path.runs, localizer, kStep)) {
    if (at.s < kSettling) continue;
    stations.push_back({at.s, at.p95, alpha_near(path.runs.front(), at.s + 0.5 * kStep, risk)});
  }
  return stations;
}

// Whether there are enough metres on both sides of two thresholds.
bool tell(const std::vector<double>& alphas, double poor, double rich) {
  const auto enough = [](std::ptrdiff_t steps) { return static_cast<double>(steps) * kStep >= kLeastMetres; };
  return enough(std::ranges::count_if(alphas, [&](double alpha) { return std::isnan(alpha) || alpha <= poor; })) &&
         enough(std::ranges::count_if(alphas, [&](double alpha) { return alpha >= rich; }));
}

// At each station, from what the error is at the first.
std::vector<double> predicted(const ErrorModel& model, const Stations& stations) {
  std::vector<double> errors{stations.front().p95};
  for (std::size_t i = 1; i < stations.size(); ++i) {
    errors.push_back(model.advanced(errors.back(), stations[i - 1].alpha, stations[i].s - stations[i - 1].s));
  }
  return errors;
}

// The logarithms of growth, recovery and least, within what makes sense of them.
ErrorModel with_parameters(ErrorModel model, const Eigen::VectorXd& logs) {
  model.growth = std::exp(std::clamp(logs[0], std::log(1e-5), std::log(1.0)));
  model.recovery = std::exp(std::clamp(logs[1], std::log(0.1), std::log(1000.0)));
  model.least = std::exp(std::clamp(logs[2], std::log(1e-4), std::log(1.0)));
  return model;
}

struct Residuals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const std::vector<Stations>& all;
  ErrorModel model;
  int count;

  int inputs() const { return 3; }
  int values() const { return count; }
  int operator()(const Eigen::VectorXd& logs, Eigen::VectorXd& residuals) const {
    const ErrorModel tried = with_parameters(model, logs);
    int row = 0;
    for (const Stations& stations : all) {
      const std::vector<double> errors = predicted(tried, stations);
      for (std::size_t i = 0; i < errors.size(); ++i) residuals[row++] = errors[i] - stations[i].p95;
    }
    return 0;
  }
};

struct Fit {
  ErrorModel model;
  double squares = std::numeric_limits<double>::infinity();
};

Fit fit_with(const std::vector<Stations>& all, int count, double poor, double rich) {
  ErrorModel model;
  model.alpha_poor = poor;
  model.alpha_rich = rich;
  Eigen::NumericalDiff<Residuals> residuals(Residuals{all, model, count});
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residuals>> solver(residuals);
  Eigen::VectorXd logs = Eigen::Vector3d(std::log(0.02), std::log(3.0), std::log(0.05));
  solver.minimize(logs);
  return {with_parameters(model, logs), solver.fvec.squaredNorm()};
}

}  // namespace

Calibration calibration_of(const DriveOptions& drive, std::size_t localizer, const SensorRig& sensor, std::optional<double> range_max) {
  return {.localizer = to_string(drive.localizers.at(localizer)),
          .sensor = sensor.name,
          .noise = sensor.range_stddev(),
          .range_max = range_max,
          .scale_bias = drive.odometry.scale_bias};
}

std::optional<std::string> refusal_of_fit(std::span<const SitePaths> sites) {
  std::vector<double> alphas;
  for (const auto& [paths, risk] : sites) {
    for (const DrivenPath& path : paths) {
      for (const TimedPose& at : poses_along(path.path, {.speed = 1.0}, kStep)) {
        if (at.s >= kSettling) alphas.push_back(risk.alpha(at.pose.x, at.pose.y, at.pose.yaw));
      }
    }
  }
  if (tell(alphas, std::ranges::max(kPoor), kRich[2])) return std::nullopt;
  return "an error model needs paths with at least 4 m of alignability up to 0.2 and 4 m of 0.3 and more to be fitted to";
}

ErrorModel fit_error_model(std::span<const SitePaths> sites, std::size_t localizer) {
  if (const auto refusal = refusal_of_fit(sites)) throw std::invalid_argument(*refusal);
  std::vector<Stations> all;
  std::vector<double> alphas;
  for (const auto& [paths, risk] : sites) {
    for (const DrivenPath& path : paths) {
      Stations stations = stations_of(path, localizer, risk);
      if (stations.size() < 2) continue;
      for (const Station& station : stations) alphas.push_back(station.alpha);
      all.push_back(std::move(stations));
    }
  }
  Fit best;
  for (const double poor : kPoor) {
    for (const double rich : kRich) {
      if (poor >= rich || !tell(alphas, poor, rich)) continue;
      Fit fit = fit_with(all, static_cast<int>(alphas.size()), poor, rich);
      if (fit.squares < best.squares) best = fit;
    }
  }
  if (!std::isfinite(best.squares)) {
    throw std::invalid_argument("the drives tell too little of poor or of rich places to fit an error model");
  }
  return best.model;
}

std::optional<ErrorModelCheck> check_error_model(const ErrorModel& model, const DrivenPath& path, std::size_t localizer,
                                                 const RiskField& risk) {
  const Stations stations = stations_of(path, localizer, risk);
  if (stations.size() < 2) return std::nullopt;
  const std::vector<double> errors = predicted(model, stations);
  double squares = 0.0, covered = 0.0, scans = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) squares += std::pow(errors[i] - stations[i].p95, 2);
  for (const Drive& drive : path.runs) {
    for (const DriveSample& sample : drive) {
      if (sample.truth.s < stations.front().s) continue;
      const auto next = std::ranges::upper_bound(stations, sample.truth.s, {}, &Station::s);
      covered += sample.error(localizer) <= errors[static_cast<std::size_t>(next - stations.begin()) - 1] ? 1.0 : 0.0;
      scans += 1.0;
    }
  }
  return ErrorModelCheck{std::sqrt(squares / static_cast<double>(errors.size())), covered / scans};
}

}  // namespace alignability
