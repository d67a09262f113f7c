// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tests/benchmark/planner_site.hpp"

namespace alignability::benchmark {

/// The times [s] at which tables have columns.
inline constexpr double kBudgets[] = {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 60.0};

/// What the path that a search would hand over costs, from when on; infinite where it has none, or one that collides.
struct Sighting {
  double seconds;
  double cost;
};
using Course = std::vector<Sighting>;

/// Infinite before the first sighting.
double cost_after(const Course& course, double seconds);
/// When the course is first at or below a cost; infinite for never [s].
double time_to(const Course& course, double cost);

using MakePlanner = std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)>;

/// When to look at a search that goes on until it is stopped: five times between budgets, up to `longest` [s].
std::vector<double> looks_until(double longest);

/// One search in one go, its path looked at after so many seconds in all, ascending, or when it ends by itself. Everything that the search
/// needs made for it counts, but the risk and clearance fields, which all share; looking at its path does not.
Course observe(const Site& site, Parts parts, const MakePlanner& make, const std::vector<double>& looks);

/// A search that takes the time it takes.
Course observe_once(const std::function<double()>& search_and_cost);

/// Of values of which some may be infinite: the middle one, of an even number the worse of the two.
double median(std::vector<double> values);

}  // namespace alignability::benchmark
