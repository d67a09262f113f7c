// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/course.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace alignability::benchmark {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

double cost_after(const Course& course, double seconds) {
  double cost = kInfinite;
  for (const Sighting& sighting : course) {
    // A budget's own look is late by what it takes to stop.
    if (sighting.seconds <= 1.02 * seconds + 1e-3) cost = sighting.cost;
  }
  return cost;
}

double time_to(const Course& course, double cost) {
  const auto found = std::ranges::find_if(course, [&](const Sighting& sighting) { return sighting.cost <= cost; });
  return found == course.end() ? kInfinite : found->seconds;
}

// From 3 ms on.
std::vector<double> looks_until(double longest) {
  constexpr int kPieces = 5;
  std::vector<double> times;
  double from = 0.003;
  for (const double to : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 60.0}) {
    for (int piece = 1; piece <= kPieces; ++piece) times.push_back(from * std::pow(to / from, static_cast<double>(piece) / kPieces));
    from = to;
  }
  std::erase_if(times, [&](double time) { return time > longest * (1.0 + 1e-9); });
  return times;
}

Course observe(const Site& site, Parts parts, const MakePlanner& make, const std::vector<double>& looks) {
  double begin = now();
  og::SimpleSetup setup = site.setup(parts);
  setup.setPlanner(make(setup.getSpaceInformation()));
  setup.setup();
  double spent = now() - begin;
  Course course;
  for (const double look : looks) {
    if (look <= spent) continue;
    begin = now();
    setup.getPlanner()->solve(ob::timedPlannerTerminationCondition(look - spent));
    spent += now() - begin;
    const bool solved = setup.haveExactSolutionPath();
    course.push_back({spent, solved ? site.true_cost(setup.getSolutionPath()) : kInfinite});
  }
  return course;
}

Course observe_once(const std::function<double()>& search_and_cost) {
  const double begin = now();
  const double cost = search_and_cost();
  return {{now() - begin, cost}};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace alignability::benchmark
