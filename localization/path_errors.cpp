// SPDX-License-Identifier: BSD-3-Clause
#include "localization/path_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/distribution.hpp"
#include "core/range.hpp"

namespace alignability {
namespace {

struct RunErrors {
  std::vector<double> errors;
  double sum = 0.0;
  double max = 0.0;
  double unsafe = 0.0;  // scans
};

RunErrors errors_of(const Drive& drive, std::size_t localizer, const ClearanceMap& clearance, double radius) {
  RunErrors run;
  for (const DriveSample& sample : drive) {
    const double error = sample.error(localizer);
    run.errors.push_back(error);
    run.sum += error;
    run.max = std::max(run.max, error);
    if (error > clearance.distance(sample.truth.pose.position()) - radius) run.unsafe += 1.0;
  }
  return run;
}

double percentile_95(std::vector<double> values) {
  std::ranges::sort(values);
  return quantile(values, 0.95);
}

}  // namespace

PathErrors path_errors(std::span<const Drive> runs, std::size_t localizer, const ClearanceMap& clearance, double radius,
                       const BootstrapOptions& options) {
  std::vector<RunErrors> all;
  for (const Drive& drive : runs) {
    if (!drive.empty()) all.push_back(errors_of(drive, localizer, clearance, radius));
  }
  using Runs = std::span<const std::size_t>;
  const auto over_scans = [&](double RunErrors::*figure) {
    return [&all, figure](Runs chosen) {
      double sum = 0.0, scans = 0.0;
      for (const std::size_t run : chosen) {
        sum += all[run].*figure;
        scans += static_cast<double>(all[run].errors.size());
      }
      return sum / scans;
    };
  };
  const auto over_runs = [&](auto figure) {
    return [&all, figure](Runs chosen) {
      double sum = 0.0;
      for (const std::size_t run : chosen) sum += figure(all[run]);
      return sum / static_cast<double>(chosen.size());
    };
  };
  const auto p95 = [&](Runs chosen) {
    std::vector<double> errors;
    for (const std::size_t run : chosen) errors.insert(errors.end(), all[run].errors.begin(), all[run].errors.end());
    return percentile_95(std::move(errors));
  };
  const auto max = [&](Runs chosen) {
    double most = 0.0;
    for (const std::size_t run : chosen) most = std::max(most, all[run].max);
    return most;
  };
  const auto figure = [&](auto of) { return bootstrap(all.size(), of, options); };
  return {.mean = figure(over_scans(&RunErrors::sum)),
          .p95 = figure(p95),
          .max = figure(max),
          .goal = figure(over_runs([](const RunErrors& run) { return run.errors.back(); })),
          .lost = figure(over_runs([](const RunErrors& run) { return run.max > kLostError ? 1.0 : 0.0; })),
          .unsafe = figure(over_scans(&RunErrors::unsafe))};
}

std::vector<ErrorAlong> errors_along(std::span<const Drive> runs, std::size_t localizer, double step) {
  if (!kPositive.contains(step)) throw std::invalid_argument("a step must be greater than 0");
  std::map<long, std::vector<double>> steps;
  for (const Drive& drive : runs) {
    for (const DriveSample& sample : drive) steps[std::lround(sample.truth.s / step)].push_back(sample.error(localizer));
  }
  std::vector<ErrorAlong> along;
  for (auto& [number, errors] : steps) {
    const Distribution distribution = distribution_of(std::move(errors));
    along.push_back({static_cast<double>(number) * step, distribution.mean, distribution.p95});
  }
  return along;
}

}  // namespace alignability
