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

// Of one number, on all paths.
struct RunErrors {
  std::vector<double> errors;  // of all scans
  double sum = 0.0;
  double max = 0.0;
  double unsafe = 0.0;  // scans
  double drives = 0.0;
  double goal = 0.0;  // sum over the drives
  double lost = 0.0;  // drives
};

void add(RunErrors& run, const Drive& drive, std::size_t localizer, const ClearanceMap& clearance, double radius) {
  if (drive.empty()) return;
  double most = 0.0;
  for (const DriveSample& sample : drive) {
    const double error = sample.error(localizer);
    run.errors.push_back(error);
    run.sum += error;
    most = std::max(most, error);
    if (error > clearance.distance(sample.truth.pose.position()) - radius) run.unsafe += 1.0;
  }
  run.max = std::max(run.max, most);
  run.drives += 1.0;
  run.goal += run.errors.back();
  run.lost += most > kLostError ? 1.0 : 0.0;
}

std::vector<RunErrors> errors_by_run(std::span<const std::vector<Drive>> paths, std::size_t localizer, const ClearanceMap& clearance,
                                     double radius) {
  std::vector<RunErrors> all;
  for (const std::vector<Drive>& runs : paths) {
    if (all.size() < runs.size()) all.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) add(all[i], runs[i], localizer, clearance, radius);
  }
  std::erase_if(all, [](const RunErrors& run) { return run.errors.empty(); });
  return all;
}

using Runs = std::span<const std::size_t>;

double percentile_95(const std::vector<RunErrors>& all, Runs chosen) {
  std::vector<double> errors;
  for (const std::size_t run : chosen) errors.insert(errors.end(), all[run].errors.begin(), all[run].errors.end());
  // Only what is about the percentile needs to be in order.
  const auto below = static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(errors.size() - 1));
  const auto at = errors.begin() + below;
  std::nth_element(errors.begin(), at, errors.end());
  const double share = 0.95 * static_cast<double>(errors.size() - 1) - static_cast<double>(below);
  return at + 1 == errors.end() ? *at : std::lerp(*at, *std::min_element(at + 1, errors.end()), share);
}

}  // namespace

PathErrors path_errors(std::span<const std::vector<Drive>> paths, std::size_t localizer, const ClearanceMap& clearance, double radius,
                       const BootstrapOptions& options) {
  const std::vector<RunErrors> all = errors_by_run(paths, localizer, clearance, radius);
  const auto sum = [&all](Runs chosen, auto figure) {
    double total = 0.0;
    for (const std::size_t run : chosen) total += figure(all[run]);
    return total;
  };
  const auto scans = [](const RunErrors& run) { return static_cast<double>(run.errors.size()); };
  const auto share = [&](double RunErrors::*figure, auto of) {
    return bootstrap(
        all.size(), [&](Runs chosen) { return sum(chosen, [&](const RunErrors& run) { return run.*figure; }) / sum(chosen, of); }, options);
  };
  const auto drives = [](const RunErrors& run) { return run.drives; };
  const auto max = [&](Runs chosen) {
    double most = 0.0;
    for (const std::size_t run : chosen) most = std::max(most, all[run].max);
    return most;
  };
  return {.mean = share(&RunErrors::sum, scans),
          .p95 = bootstrap(
              all.size(), [&](Runs chosen) { return percentile_95(all, chosen); }, options),
          .max = bootstrap(all.size(), max, options),
          .goal = share(&RunErrors::goal, drives),
          .lost = share(&RunErrors::lost, drives),
          .unsafe = share(&RunErrors::unsafe, scans)};
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
