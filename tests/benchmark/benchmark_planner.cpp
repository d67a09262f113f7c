// SPDX-License-Identifier: BSD-3-Clause
// benchmark_planner: how many queries a second, and what paths cost after how long, in R², as Markdown. Run it where maps/ is.
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>

#include "costmap/map_server.hpp"
#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/field_planner.hpp"
#include "planner/plan.hpp"
#include "planner/pose_goal.hpp"
#include "tests/benchmark/grid_search.hpp"
#include "tests/planner/random_sites.hpp"

namespace {

using namespace alignability;
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr std::array kBudgets{0.03, 0.1, 0.3, 1.0, 3.0};  // [s]
constexpr std::uint32_t kSeeds = 3;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// A user's own objective on OMPL's stock integral.
class StockObjective : public ob::StateCostIntegralObjective {
 public:
  StockObjective(const ob::SpaceInformationPtr& si, const PlanarMotion& motion)
      : ob::StateCostIntegralObjective(si, true), motion_(motion) {}
  ob::Cost stateCost(const ob::State* state) const override {
    const double* at = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return ob::Cost(1.0 + motion_.weight * motion_.risk->risk(at[0], at[1], 0.0));
  }

 private:
  PlanarMotion motion_;
};

struct Site {
  const char* name;
  PlanProblem problem;
  PlanningFields fields{problem};
  DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  PlanarMotion motion{fields.risk, fields.clearance, problem.query.weight, problem.query.robot.radius};

  std::shared_ptr<const RouteBounds> bounds() const {
    return std::make_shared<const RouteBounds>(area, motion.weight, problem.query.start.position(), problem.query.goal.position(),
                                               problem.query.goal_tolerance.position);
  }
};

enum class Parts { stock, ours, ours_with_bounds };

// Start, goal and maps alike; cost and checks by OMPL's own means or by ours.
og::SimpleSetup setup_of(const Site& site, Parts parts) {
  const GridGeometry& map = site.problem.occupancy.geometry();
  const auto plane = std::make_shared<ob::RealVectorStateSpace>();
  for (const int axis : {0, 1}) plane->addDimension(map.origin[axis], map.upper_corner()[axis]);
  og::SimpleSetup setup(plane);
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  setup.setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, site.area));
  if (parts == Parts::stock) {
    setup.setOptimizationObjective(std::make_shared<StockObjective>(si, site.motion));
    // A step of a cell, for checks and integral; by default it would be a hundredth of the map, and most paths collide.
    si->setStateValidityCheckingResolution(map.resolution / plane->getMaximumExtent());
  } else {
    si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, site.area));
    const auto objective = std::make_shared<AlignabilityObjective>(si, site.fields.risk, ObjectiveOptions{.weight = site.motion.weight});
    if (parts == Parts::ours_with_bounds) objective->set_bounds(site.bounds());
    setup.setOptimizationObjective(objective);
  }
  ob::ScopedState<> start(plane);
  start = std::vector{site.problem.query.start.x, site.problem.query.start.y};
  setup.setStartState(start);
  setup.setGoal(std::make_shared<PoseGoal>(si, site.problem.query.goal, site.problem.query.goal_tolerance));
  return setup;
}

// Infinite for no path, and for one that an exact check refuses.
double true_cost(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!motion.is_allowed(path[i - 1], path[i])) return std::numeric_limits<double>::infinity();
    cost += motion.cost(path[i - 1], path[i]);
  }
  return path.empty() ? std::numeric_limits<double>::infinity() : cost;
}

// The budget includes whatever the search needs made for it.
template <typename Planner>
PlanarPath ompl_path(const Site& site, Parts parts, double budget) {
  const double begin = now();
  og::SimpleSetup setup = setup_of(site, parts);
  const auto planner = std::make_shared<Planner>(setup.getSpaceInformation());
  if constexpr (std::is_same_v<Planner, og::RRTstar>) planner->setInformedSampling(parts == Parts::ours_with_bounds);
  if constexpr (std::is_same_v<Planner, og::BITstar>) planner->setName("kBITstar");
  setup.setPlanner(planner);
  setup.setup();
  PlanarPath path;
  const double left = budget - (now() - begin);
  if (left <= 0.0 || setup.solve(left) != ob::PlannerStatus::EXACT_SOLUTION) return path;
  for (const ob::State* state : setup.getSolutionPath().getStates()) {
    const double* at = state->as<ob::RealVectorStateSpace::StateType>()->values;
    path.emplace_back(at[0], at[1]);
  }
  return path;
}

void print_row(const char* name, const std::function<double(double)>& cell) {
  std::printf("| %s |", name);
  for (const double budget : kBudgets) {
    std::vector<double> costs;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      ompl::RNG::setSeed(seed);
      costs.push_back(cell(budget));
    }
    std::ranges::sort(costs);
    const auto solved = std::ranges::count_if(costs, [](double cost) { return std::isfinite(cost); });
    std::printf(solved > static_cast<long>(kSeeds) / 2 ? " %.2f" : " –", costs[kSeeds / 2]);
    if (solved > 0) std::printf(" (%.2f to %.2f)", costs.front(), costs[static_cast<std::size_t>(solved) - 1]);
    if (solved < kSeeds) std::printf(" %ld of %u", static_cast<long>(solved), kSeeds);
    std::printf(" |");
  }
  std::printf("\n");
  std::fflush(stdout);
}

// One that takes the time it takes.
void print_once(const char* name, const PlanarMotion& motion, const std::function<std::optional<PlanarPath>()>& search) {
  const double begin = now();
  const auto path = search();
  const double seconds = now() - begin;
  const double cost = path ? true_cost(*path, motion) : std::numeric_limits<double>::infinity();
  std::printf("%s: %.2f after %.3f s\n", name, cost, seconds);
}

void print_costs(const Site& site) {
  std::printf("\n%s, certified lower bound %.2f\n\n| median (range) after |", site.name,
              site.bounds()->to_goal(site.problem.query.start.position()));
  for (const double budget : kBudgets) std::printf(" %g s |", budget);
  std::printf("\n|---|---|---|---|---|---|\n");
  const auto row = [&]<typename Planner>(const char* name, Parts parts, std::type_identity<Planner>) {
    print_row(name, [&](double budget) { return true_cost(ompl_path<Planner>(site, parts, budget), site.motion); });
  };
  row("stock RRT*", Parts::stock, std::type_identity<og::RRTstar>());
  row("stock BIT*", Parts::stock, std::type_identity<og::BITstar>());
  row("stock PRM*", Parts::stock, std::type_identity<og::PRMstar>());
  row("RRT*, our parts", Parts::ours, std::type_identity<og::RRTstar>());
  row("RRT*, with bounds", Parts::ours_with_bounds, std::type_identity<og::RRTstar>());
  row("BIT*, our parts", Parts::ours, std::type_identity<og::BITstar>());
  row("BIT*, with bounds", Parts::ours_with_bounds, std::type_identity<og::BITstar>());
  row("PRM*, our parts", Parts::ours, std::type_identity<og::PRMstar>());
  std::printf("\n");
  const auto start = site.problem.query.start.position(), goal = site.problem.query.goal.position();
  print_once("field, its own lattice included", site.motion, [&]() -> std::optional<PlanarPath> {
    PlanarPath path = ompl_path<FieldPlanner>(site, Parts::ours, 60.0);
    return path.empty() ? std::nullopt : std::optional(path);
  });
  print_once("A*, 8-connected", site.motion,
             [&] { return benchmark::grid_path(benchmark::GridSearch::eight_connected, site.motion, start, goal); });
  print_once("Theta*", site.motion, [&] { return benchmark::grid_path(benchmark::GridSearch::any_angle, site.motion, start, goal); });
}

// Edges as a planner tries them: up to some metres long.
void print_queries(const Site& site) {
  const auto per_second = [&](Parts parts) {
    og::SimpleSetup setup = setup_of(site, parts);
    setup.setPlanner(std::make_shared<og::RRTstar>(setup.getSpaceInformation()));
    setup.setup();
    const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
    const auto objective = setup.getOptimizationObjective();
    ompl::RNG::setSeed(1);
    std::vector<ob::ScopedState<>> states;
    const ob::StateSamplerPtr sampler = si->allocStateSampler();
    while (states.size() < 2000) {
      ob::ScopedState<> from(si), to(si);
      do sampler->sampleUniform(from.get());
      while (!si->isValid(from.get()));
      sampler->sampleUniformNear(to.get(), from.get(), 3.0);
      states.push_back(from);
      states.push_back(to);
    }
    double sum = 0.0;
    std::size_t edges = 0;
    const double begin = now();
    while (now() - begin < 1.0) {
      for (std::size_t i = 0; i < states.size(); i += 2, ++edges) {
        sum += objective->motionCost(states[i].get(), states[i + 1].get()).value();
        sum += si->checkMotion(states[i].get(), states[i + 1].get()) ? 1.0 : 0.0;
      }
    }
    const double seconds = now() - begin;
    return sum > 0.0 ? static_cast<double>(edges) / seconds : 0.0;
  };
  const double stock = per_second(Parts::stock);
  const double ours = per_second(Parts::ours);
  std::printf("%s: motionCost and checkMotion of an edge: stock %.0f a second, ours %.0f, %.0f times as many\n", site.name, stock, ours,
              ours / stock);
}

}  // namespace

int main(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  std::vector<std::unique_ptr<Site>> sites;
  sites.push_back(std::make_unique<Site>("the shipped warehouse", load_problem(read_problem_file("maps/warehouse/problem.yaml"))));
  if (argc > 1) {  // nav2's warehouse.yaml
    PlanProblem nav2{read_occupancy_map(argv[1]), {}, {}};
    nav2.alignability = test::random_alignability(nav2.occupancy.geometry(), 1);
    nav2.query.robot.radius = 0.3;
    nav2.query.start = {-5.0, -20.0, 0.0};
    nav2.query.goal = {8.3, 18.0, 0.0};
    sites.push_back(std::make_unique<Site>("nav2's warehouse, random alignability", std::move(nav2)));
  }
  for (const auto& site : sites) print_queries(*site);
  for (const auto& site : sites) print_costs(*site);
}
