// SPDX-License-Identifier: BSD-3-Clause
#include "localization/cell_errors.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "core/rank_correlation.hpp"

namespace alignability {
namespace {

constexpr double kLargeError = 0.3, kSmallError = 0.1;  // [m], of the paper's Fig. 4
constexpr double kPoor = 0.1, kRich = 0.4;

struct Visits {
  double sum = 0.0;  // of errors
  double scans = 0.0;
  double grown = 0.0;
  double metres = 0.0;
};

using VisitsOfRun = std::map<std::size_t, Visits>;  // by the cell's index

// What lies between two scans belongs to the cell of the first.
void add_visits(VisitsOfRun& visits, const Drive& drive, std::size_t localizer, const GridGeometry& cells, double settling) {
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const TimedPose& truth = drive[i].truth;
    const auto cell = cells.cell_near(truth.pose.position());
    if (!cell || truth.s < settling) continue;
    Visits& at = visits[cells.index(*cell)];
    const double error = drive[i].error(localizer);
    at.sum += error;
    at.scans += 1.0;
    if (i + 1 == drive.size()) continue;
    at.grown += drive[i + 1].error(localizer) - error;
    at.metres += drive[i + 1].truth.s - truth.s;
  }
}

// By the number of the run, on all paths.
std::vector<VisitsOfRun> all_visits(std::span<const std::vector<Drive>> paths, std::size_t localizer, const GridGeometry& cells,
                                    double settling) {
  std::vector<VisitsOfRun> all;
  for (const std::vector<Drive>& runs : paths) {
    if (all.size() < runs.size()) all.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) add_visits(all[i], runs[i], localizer, cells, settling);
  }
  return all;
}

std::vector<CellErrors> joined(const std::vector<VisitsOfRun>& all, std::span<const std::size_t> runs, const GridGeometry& cells) {
  struct Sum {
    double error = 0.0;  // of the runs' means
    double runs = 0.0;
    double grown = 0.0;
    double metres = 0.0;
  };
  std::map<std::size_t, Sum> sums;
  for (const std::size_t run : runs) {
    for (const auto& [index, visits] : all[run]) {
      Sum& sum = sums[index];
      sum.error += visits.sum / visits.scans;
      sum.runs += 1.0;
      sum.grown += visits.grown;
      sum.metres += visits.metres;
    }
  }
  std::vector<CellErrors> errors;
  for (const auto& [index, sum] : sums) {
    const double growth = sum.metres > 0.0 ? sum.grown / sum.metres : std::numeric_limits<double>::quiet_NaN();
    errors.push_back({cells.cell_of(index), sum.error / sum.runs, growth, sum.metres});
  }
  return errors;
}

std::vector<std::size_t> each_once(std::size_t count) {
  std::vector<std::size_t> runs(count);
  for (std::size_t i = 0; i < count; ++i) runs[i] = i;
  return runs;
}

double correlation(const std::vector<CellErrors>& errors, double CellErrors::*figure, const Grid<float>& reading) {
  std::vector<double> readings, figures;
  for (const CellErrors& at : errors) {
    if (std::isnan(reading[at.cell]) || std::isnan(at.*figure)) continue;
    readings.push_back(reading[at.cell]);
    figures.push_back(at.*figure);
  }
  return rank_correlation(readings, figures);
}

}  // namespace

std::vector<CellErrors> cell_errors(std::span<const std::vector<Drive>> paths, std::size_t localizer, const GridGeometry& cells,
                                    double settling) {
  const std::vector<VisitsOfRun> all = all_visits(paths, localizer, cells, settling);
  return joined(all, each_once(all.size()), cells);
}

Statement::Verdict Statement::verdict() const {
  if (cells < kLeastCells || others < kLeastCells) return Verdict::untested;
  return exceptions == 0 ? Verdict::holds : Verdict::fails;
}

Prediction prediction(std::span<const std::vector<Drive>> paths, std::size_t localizer, const Grid<float>& reading, double settling,
                      const BootstrapOptions& options) {
  const GridGeometry& cells = reading.geometry();
  const std::vector<VisitsOfRun> all = all_visits(paths, localizer, cells, settling);
  const auto correlation_with = [&](double CellErrors::*figure) {
    return bootstrap(
        all.size(), [&](std::span<const std::size_t> chosen) { return correlation(joined(all, chosen, cells), figure, reading); }, options);
  };
  Prediction prediction{.error = correlation_with(&CellErrors::error),
                        .growth = correlation_with(&CellErrors::growth),
                        .large_only_where_poor = {},
                        .small_where_rich = {}};
  for (const CellErrors& at : joined(all, each_once(all.size()), cells)) {
    const double value = reading[at.cell];
    if (std::isnan(value)) continue;
    Statement& large = prediction.large_only_where_poor;
    ++(value >= kPoor ? large.cells : large.others);
    if (value >= kPoor && at.error > kLargeError) ++large.exceptions;
    Statement& small = prediction.small_where_rich;
    ++(value > kRich ? small.cells : small.others);
    if (value > kRich && at.error >= kSmallError) ++small.exceptions;
  }
  return prediction;
}

}  // namespace alignability
