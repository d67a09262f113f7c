// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_shortening.hpp"

#include <ompl/geometric/PathSimplifier.h>

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

bool is_solution(og::PathGeometric& path, const ob::ProblemDefinition& problem) {
  const ob::SpaceInformationPtr& si = problem.getSpaceInformation();
  return path.getStateCount() > 0 && si->equalStates(path.getState(0), problem.getStartState(0)) &&
         problem.getGoal()->isSatisfied(path.getStates().back()) && path.check();
}

}  // namespace

og::PathGeometric shortened(const og::PathGeometric& path, const ob::ProblemDefinition& problem, const StopTest& stop) {
  constexpr int kRounds = 8;
  constexpr double kWorthAnotherRound = 1e-3;  // of the cost
  const ob::OptimizationObjectivePtr& objective = problem.getOptimizationObjective();
  og::PathSimplifier simplifier(problem.getSpaceInformation(), nullptr, objective);
  // perturbPath moves states by this far: a tenth of the way across an aisle.
  constexpr double kPerturbation = 0.3;
  og::PathGeometric best = path;
  for (int round = 0; round < kRounds; ++round) {
    if (is_told_to_stop(stop)) break;
    og::PathGeometric candidate = best;
    simplifier.shortcutPath(candidate);
    simplifier.perturbPath(candidate, kPerturbation);
    const double before = best.cost(objective).value();
    const double after = candidate.cost(objective).value();
    if (!(after < before) || !is_solution(candidate, problem)) break;
    best = candidate;
    if (before - after < kWorthAnotherRound * before) break;
  }
  return best;
}

}  // namespace alignability
