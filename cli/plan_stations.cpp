// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plan_stations.hpp"

#include <chrono>
#include <iostream>

#include "cli/exit_code.hpp"
#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "cli/progress_bar.hpp"
#include "cli/stations_output.hpp"
#include "core/file.hpp"

namespace alignability::cli {
namespace {

// Each way once: the way back is the same or much like it.
void draw_ways(const PlanProblem& problem, const RiskField& risk, const StationPlans& plans, const std::filesystem::path& name,
               const PictureKinds& kinds) {
  std::vector<DrawnPath> ways;
  for (std::size_t from = 0; from < plans.size(); ++from) {
    for (std::size_t to = from + 1; to < plans.size(); ++to) {
      const PlanResult& way = plans[from][to].status == PlanStatus::solved ? plans[from][to] : plans[to][from];
      if (way.status != PlanStatus::solved) continue;
      ways.push_back(drawn(way, risk, "", kRiskAwareColour, LineStyle::solid));
      ways.back().label.clear();
    }
  }
  PathPictureOptions options = picture_options(problem.query, risk, problem.occupancy.geometry(), name.filename().string());
  options.start.reset();
  options.goal.reset();
  for (const auto& file : picture_files(name, kinds)) draw_paths(problem.alignability, problem.occupancy, ways, options, file);
}

// Whether there is a way from each station to each.
bool tell_of_missing_ways(std::span<const Station> stations, const StationPlans& plans) {
  bool complete = true;
  for (std::size_t from = 0; from < plans.size(); ++from) {
    for (std::size_t to = 0; to < plans.size(); ++to) {
      if (plans[from][to].status == PlanStatus::solved) continue;
      complete = false;
      std::cerr << "from " << stations[from].name << " to " << stations[to].name << ": " << to_string(plans[from][to].status) << '\n';
    }
  }
  return complete;
}

}  // namespace

int plan_stations(const PlanProblem& problem, const StationsRun& run, const std::stop_token& stop) {
  const std::vector<Station> stations = read_station_file(run.stations);
  const PlanningFields fields(problem);
  ProgressBar bar("stations");
  const auto begin = std::chrono::steady_clock::now();
  const StationPlans plans = plan_between(stations, problem.query, fields, {.progress = bar.callback(), .stop = stop});
  const double seconds = fields.seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (run.output) {
    const std::filesystem::path name = output_name(*run.output);
    write_file(with_ending(name, ".json"), stations_json(stations, plans, seconds).dump(2) + '\n');
    write_stations_csv(stations, plans, with_ending(name, ".csv"));
    draw_ways(problem, *fields.risk, plans, name, run.pictures);
  }
  if (run.json) {
    print({stations_json(stations, plans, seconds)});
  } else {
    print_stations(stations, plans, seconds);
  }
  return tell_of_missing_ways(stations, plans) ? kYes : kNo;
}

}  // namespace alignability::cli
