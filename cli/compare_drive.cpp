// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compare_drive.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/compare_output.hpp"
#include "cli/drive_paths.hpp"
#include "cli/validate_output.hpp"

namespace alignability::cli {

std::vector<std::vector<DrivenComparison>> drive_comparisons(std::span<const Comparison> comparisons, const DriveSite& site, int runs,
                                                             const ClearanceMap& clearance) {
  std::vector<DrivenPath> paths;
  for (const Comparison& comparison : comparisons) {
    paths.push_back({"shortest", comparison.shortest.path, {}});
    paths.push_back({"risk-aware", comparison.risk_aware.path, {}});
  }
  TrialOptions trials = site.trials;
  trials.runs = runs;
  paths = driven(std::move(paths), site, trials);
  std::vector<std::vector<DrivenComparison>> compared(comparisons.size());
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const double radius = circumscribed_radius(comparisons[i].shortest.query.robot);
    for (std::size_t k = 0; k < trials.drive.localizers.size(); ++k) {
      compared[i].push_back(
          {trials.drive.localizers[k], errors_of(paths[2 * i], k, clearance, radius), errors_of(paths[2 * i + 1], k, clearance, radius)});
    }
  }
  return compared;
}

std::vector<std::size_t> most_different(std::span<const Comparison> pairs, std::size_t count) {
  const auto difference = [&](std::size_t i) {
    return pairs[i].shortest.figures.risk_integral - pairs[i].risk_aware.figures.risk_integral;
  };
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (solved(pairs[i])) numbers.push_back(i);
  }
  std::ranges::stable_sort(numbers, std::ranges::greater{}, difference);
  numbers.resize(std::min(count, numbers.size()));
  return numbers;
}

Json drive_json(std::span<const DrivenComparison> driven, int runs) {
  Json json = Json::array();
  for (const DrivenComparison& by : driven) {
    json.push_back({{"localizer", to_string(by.localizer)},
                    {"runs", runs},
                    {"shortest", errors_json(by.shortest.over_all)},
                    {"risk_aware", errors_json(by.risk_aware.over_all)}});
  }
  return json;
}

void print_drive(std::span<const DrivenComparison> driven, int runs) {
  for (const DrivenComparison& by : driven) {
    std::printf("\n%s, driven %d times\n", to_string(by.localizer), runs);
    print_row("error, mean", by.shortest.over_all.mean.value, by.risk_aware.over_all.mean.value, "m");
    print_row("error, 95 %", by.shortest.over_all.p95.value, by.risk_aware.over_all.p95.value, "m");
    print_row("error, max", by.shortest.over_all.max.value, by.risk_aware.over_all.max.value, "m");
    print_row("error at the goal", by.shortest.over_all.goal.value, by.risk_aware.over_all.goal.value, "m");
    print_row("runs lost", 100.0 * by.shortest.over_all.lost.value, 100.0 * by.risk_aware.over_all.lost.value, "%");
  }
}

void print_driven_pairs(std::span<const Comparison> pairs, std::span<const std::size_t> chosen,
                        std::span<const std::vector<DrivenComparison>> driven, int runs) {
  std::printf("\nthe %zu pairs that differ most, driven %d times on either path; error [m] and runs lost, shortest / risk-aware\n",
              chosen.size(), runs);
  std::printf("%5s %7s %15s  %-17s %15s %15s %15s\n", "pair", "length", "blind [m]", "localizer", "mean", "95 %", "lost [%]");
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Comparison& pair = pairs[chosen[i]];
    for (const DrivenComparison& by : driven[i]) {
      std::printf("%5zu %5.2f x %6.1f / %6.1f  %-17s %6.3f / %6.3f %6.3f / %6.3f %6.0f / %6.0f\n", chosen[i], length_ratio(pair),
                  pair.shortest.figures.blind_length, pair.risk_aware.figures.blind_length, to_string(by.localizer),
                  by.shortest.over_all.mean.value, by.risk_aware.over_all.mean.value, by.shortest.over_all.p95.value,
                  by.risk_aware.over_all.p95.value, 100.0 * by.shortest.over_all.lost.value, 100.0 * by.risk_aware.over_all.lost.value);
    }
  }
}

}  // namespace alignability::cli
