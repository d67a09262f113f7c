// SPDX-License-Identifier: BSD-3-Clause
// benchmark_growth: how the time and the memory of a plan grow with the site, from 10^5 to 10^8 cells (or as many as the first argument
// says), and what all ways between fifty stations take in the shipped warehouse. Run it where maps/ is.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>

#include "costmap/map_server.hpp"
#include "planner/random_pairs.hpp"
#include "planner/station_matrix.hpp"

namespace alignability {
namespace {

constexpr double kStreet = 4.0;  // [m] between warehouses
constexpr float kStreetAlpha = 0.3f;
constexpr double kDoor = 3.0;  // [m], through the outer walls at either end of the corridor
constexpr double kDoorAt = 20.0;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

PlanProblem shipped_warehouse() { return load_problem(read_problem_file("maps/warehouse/problem.yaml")); }

// A square of warehouses in rows, with streets between and doors to them.
template <typename Value>
Grid<float> tiled(const GridGeometry& tile, double side, float street, Value value) {
  const int cells = static_cast<int>(std::round(side / tile.resolution));
  const int gap = static_cast<int>(std::round(kStreet / tile.resolution));
  Grid<float> site({.resolution = tile.resolution, .origin = {0.0, 0.0}, .width = cells, .height = cells}, street);
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const Cell within{x % (tile.width + gap), y % (tile.height + gap)};
      if (tile.contains(within)) site[Cell{x, y}] = value(within);
    }
  }
  return site;
}

PlanProblem site_of(const PlanProblem& warehouse, double side) {
  const GridGeometry& tile = warehouse.occupancy.geometry();
  const auto is_door = [&](Cell cell) {
    const Eigen::Vector2d at = tile.center(cell);
    return std::abs(at.y() - kDoorAt) < 0.5 * kDoor && std::min(at.x(), tile.extent().x() - at.x()) < 5.0;
  };
  const auto occupancy = [&](Cell cell) {
    return is_door(cell) ? 0.0f : warehouse.occupancy.occupancy(cell).value_or(std::numeric_limits<float>::quiet_NaN());
  };
  const Grid<float>& alpha = warehouse.alignability.alpha();
  PlanProblem site{OccupancyMap(tiled(tile, side, 0.0f, occupancy)), {}, warehouse.query};
  Grid<float> tiled_alpha = tiled(alpha.geometry(), side, kStreetAlpha, [&](Cell cell) { return alpha[cell]; });
  site.alignability.geometry = tiled_alpha.geometry();
  site.alignability.layers.push_back({"alpha", std::move(tiled_alpha)});
  return site;
}

// Of some random pairs, the one that is farthest apart.
PosePair far_apart(const PlanProblem& site) {
  const PlanningFields fields(site);
  const DrivableArea area(fields.clearance, fields.risk, site.query.robot);
  const std::vector<PosePair> pairs = random_pairs(area, site.query.goal_tolerance.position, 20, 1);
  return *std::ranges::max_element(pairs, {}, [](const PosePair& pair) { return (pair.start.position() - pair.goal.position()).norm(); });
}

void print_growth(const PlanProblem& warehouse, double most_cells) {
  std::printf("%12s %10s %12s %12s %12s %10s %10s\n", "cells", "side", "length", "gap", "plan", "a cell", "peak");
  for (double cells = 1e5; cells <= 1.001 * most_cells; cells *= 10.0) {
    PlanProblem site = site_of(warehouse, 0.1 * std::sqrt(cells));
    const PosePair pair = far_apart(site);
    site.query.start = pair.start;
    site.query.goal = pair.goal;
    const double begin = now();
    const PlanResult result = plan(site, {});
    const double seconds = now() - begin;
    if (result.status != PlanStatus::solved) {
      std::printf("%12.0f %s\n", cells, to_string(result.status));
      continue;
    }
    const double size = static_cast<double>(site.occupancy.geometry().size());
    std::printf("%12.0f %8.1f m %10.1f m %10.2f %% %10.2f s %7.2f us %7.0f MB\n", size, 0.1 * std::sqrt(size), result.figures.length,
                100.0 * (result.cost / *result.lower_bound - 1.0), seconds, 1e6 * seconds / size, peak_megabytes());
  }
}

void print_stations(const PlanProblem& warehouse) {
  constexpr std::size_t kStations = 50;
  const PlanningFields fields(warehouse);
  const DrivableArea area(fields.clearance, fields.risk, warehouse.query.robot);
  std::vector<Station> stations;
  for (const PosePair& pair : random_pairs(area, warehouse.query.goal_tolerance.position, kStations / 2, 1)) {
    for (const Pose2& at : {pair.start, pair.goal}) stations.push_back({std::to_string(stations.size()), at});
  }
  const double begin = now();
  const auto plans = plan_between(stations, warehouse.query, fields, {});
  const double together = now() - begin;
  std::size_t solved = 0;
  for (const auto& row : plans) solved += static_cast<std::size_t>(std::ranges::count(row, PlanStatus::solved, &PlanResult::status));
  PlanQuery alone = warehouse.query;
  alone.start = stations[0].pose;
  alone.goal = stations[1].pose;
  const double before = now();
  plan(alone, fields, {});
  std::printf("%zu stations of the shipped warehouse: %zu of %zu ways in %.2f s; one plan alone takes %.3f s\n", stations.size(), solved,
              stations.size() * stations.size(), together, now() - before);
}

void run(double most_cells) {
  const PlanProblem warehouse = shipped_warehouse();
  print_stations(warehouse);
  print_growth(warehouse, most_cells);
}

}  // namespace
}  // namespace alignability

int main(int argc, char** argv) {
  try {
    alignability::run(argc > 1 ? std::atof(argv[1]) : 1e8);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
