// SPDX-License-Identifier: BSD-3-Clause
// benchmark_planner [--seeds N] [--longest SECONDS] [--shared FOLDER] [--only NAME …] [--site TEXT]: how many queries a second, and what
// paths cost after how long, as Markdown. Run it where maps/ is. Sites whose maps are not in the folder, ../shared/data unless told, are
// left out.
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "costmap/map_server.hpp"
#include "planner/field_planner.hpp"
#include "tests/benchmark/course.hpp"
#include "tests/benchmark/grid_search.hpp"
#include "tests/planner/random_sites.hpp"

namespace {

using namespace alignability;
using namespace alignability::benchmark;
namespace ob = ompl::base;
namespace og = ompl::geometric;

struct Options {
  std::uint32_t seeds = 3;
  double longest = 10.0;  // [s]
  std::filesystem::path shared = "../shared/data";
  std::vector<std::string> only;  // the contenders that are run, instead of all
  std::string site;               // what the names of the sites that it is run on have in them
};

struct Contender {
  std::string name;
  std::function<Course(const Site&, double longest)> run;
  bool repeats = false;  // whether it does the same whatever the seed
  bool in_se2 = true;
};

struct Result {
  std::string name;
  std::vector<Course> courses;
};

template <typename Planner>
Contender ompl_contender(std::string name, Parts parts) {
  const auto make = [parts](const ob::SpaceInformationPtr& si) -> ob::PlannerPtr {
    auto planner = std::make_shared<Planner>(si);
    if constexpr (std::is_same_v<Planner, og::RRTstar>) planner->setInformedSampling(parts == Parts::ours_with_bounds);
    if constexpr (std::is_same_v<Planner, og::BITstar>) planner->setName("kBITstar");
    return planner;
  };
  // Ours ends by itself, and where it is stopped before it begins anew.
  constexpr bool kEnds = std::is_same_v<Planner, FieldPlanner>;
  const auto run = [=](const Site& site, double longest) {
    return observe(site, parts, make, kEnds ? std::vector{longest} : looks_until(longest));
  };
  return {std::move(name), run, kEnds};
}

Contender grid_contender(std::string name, GridSearch kind) {
  const auto run = [kind](const Site& site, double) {
    const PlanQuery& query = site.problem.query;
    const PlanarMotion motion{site.fields.risk, site.fields.clearance, query.weight, query.robot.radius};
    return observe_once([&] {
      const auto path = grid_path(kind, motion, query.start.position(), query.goal.position());
      double cost = path ? 0.0 : std::numeric_limits<double>::infinity();
      for (std::size_t i = 1; path && i < path->size(); ++i) cost += motion.cost((*path)[i - 1], (*path)[i]);
      return cost;
    });
  };
  return {std::move(name), run, true, false};
}

std::vector<Contender> contenders() {
  return {ompl_contender<og::RRTstar>("RRT*, stock", Parts::stock),
          ompl_contender<og::RRTstar>("RRT*, our parts", Parts::ours),
          ompl_contender<og::RRTstar>("RRT*, our parts and bounds", Parts::ours_with_bounds),
          ompl_contender<og::BITstar>("BIT*, stock", Parts::stock),
          ompl_contender<og::BITstar>("BIT*, our parts", Parts::ours),
          ompl_contender<og::BITstar>("BIT*, our parts and bounds", Parts::ours_with_bounds),
          ompl_contender<og::PRMstar>("PRM*, stock", Parts::stock),
          ompl_contender<og::PRMstar>("PRM*, our parts", Parts::ours),
          grid_contender("A*, 8-connected", GridSearch::eight_connected),
          grid_contender("Theta*", GridSearch::any_angle),
          ompl_contender<FieldPlanner>("field", Parts::ours)};
}

bool runs_in(const Contender& contender, MotionSpace space) {
  // Its road map takes motions for ones that can be driven back.
  if (is_curved(space) && contender.name.starts_with("PRM*")) return false;
  return space == MotionSpace::r2 || contender.in_se2;
}

void print_cell(const std::vector<Course>& courses, double budget, double bound) {
  std::vector<double> costs;
  for (const Course& course : courses) costs.push_back(cost_after(course, budget));
  std::ranges::sort(costs);
  const auto solved = static_cast<std::size_t>(std::ranges::count_if(costs, [](double cost) { return std::isfinite(cost); }));
  const double middle = median(costs);
  if (std::isfinite(middle)) {
    std::printf(" %.2f, × %.3f", middle, middle / bound);
  } else {
    std::printf(" –");
  }
  if (solved > 0 && costs.front() != costs[solved - 1]) std::printf(" (%.2f to %.2f)", costs.front(), costs[solved - 1]);
  if (solved < costs.size()) std::printf(" %zu of %zu", solved, costs.size());
  std::printf(" |");
}

const Result& result_of(const std::vector<Result>& results, const std::string& name) {
  return *std::ranges::find(results, name, &Result::name);
}

double median_time_to(const Result& result, double cost) {
  std::vector<double> times;
  for (const Course& course : result.courses) times.push_back(time_to(course, cost));
  return median(times);
}

// How long parts take to the costs that stock has after each budget.
void print_speed_up(const std::vector<Result>& results, const char* planner, const char* parts, double longest) {
  const Result& stock = result_of(results, planner + std::string(", stock"));
  const Result& ours = result_of(results, planner + std::string(", ") + parts);
  std::printf("%s, %s: to what stock has after", planner, parts);
  for (const double budget : kBudgets) {
    if (budget > longest) break;
    std::vector<double> costs;
    for (const Course& course : stock.courses) costs.push_back(cost_after(course, budget));
    const double cost = median(costs);
    if (!std::isfinite(cost)) continue;
    const double stock_time = median_time_to(stock, cost);
    const double time = median_time_to(ours, cost);
    std::printf(" %g s (%.2f, first after %.3g s): %.3g s, %.1f times sooner;", budget, cost, stock_time, time, stock_time / time);
  }
  std::printf("\n");
}

void print_first_solution(const std::vector<Result>& results, double bound, double longest) {
  double least = std::numeric_limits<double>::infinity();
  for (const Result& result : results) {
    for (const Course& course : result.courses) {
      for (const Sighting& sighting : course) least = std::min(least, sighting.cost);
    }
  }
  const Course& field = result_of(results, "field").courses.front();
  const Result& rrtstar = result_of(results, "RRT*, stock");
  std::printf(
      "\nThe least cost that any run had is %.3f, %.4f times the bound. `field`: first solution %.3f after %.4f s, %.3f %% above it. "
      "Stock RRT* has that cost after %.3g s, one within 1 %% of the least after %.3g s, within 5 %% after %.3g s (infinite: not within %g "
      "s, in the median).\n",
      least, least / bound, field.front().cost, field.front().seconds, 100.0 * (field.front().cost / least - 1.0),
      median_time_to(rrtstar, field.front().cost), median_time_to(rrtstar, 1.01 * least), median_time_to(rrtstar, 1.05 * least), longest);
}

bool is_wanted(const std::string& contender, const Options& options) {
  return options.only.empty() || std::ranges::find(options.only, contender) != options.only.end();
}

void print_costs(const Site& site, const Options& options) {
  const double bound = site.lower_bound();
  std::printf(
      "\n## %s\n\nCertified lower bound %.3f. The fields that all share took %.3f s. Median, × median over bound, (range), runs with "
      "a path where not all have one.\n\n| after |",
      site.name.c_str(), bound, site.fields.seconds);
  std::size_t columns = 0;
  for (const double budget : kBudgets) {
    if (budget > options.longest) break;
    std::printf(" %g s |", budget);
    ++columns;
  }
  std::printf("\n|---|");
  for (std::size_t i = 0; i < columns; ++i) std::printf("---|");
  std::printf("\n");
  std::vector<Result> results;
  for (const Contender& contender : contenders()) {
    if (!runs_in(contender, site.problem.query.motion.space)) continue;
    if (!is_wanted(contender.name, options)) continue;
    Result result{contender.name, {}};
    for (std::uint32_t seed = 1; seed <= (contender.repeats ? 1 : options.seeds); ++seed) {
      ompl::RNG::setSeed(seed);
      result.courses.push_back(contender.run(site, options.longest));
    }
    std::printf("| %s |", result.name.c_str());
    for (std::size_t i = 0; i < columns; ++i) print_cell(result.courses, kBudgets[i], bound);
    std::printf("\n");
    std::fflush(stdout);
    results.push_back(std::move(result));
  }
  if (is_wanted("field", options) && is_wanted("RRT*, stock", options)) print_first_solution(results, bound, options.longest);
  if (!options.only.empty()) return;
  std::printf("\n");
  for (const char* parts : {"our parts", "our parts and bounds"}) {
    for (const char* planner : {"RRT*", "BIT*"}) print_speed_up(results, planner, parts, options.longest);
  }
  if (!is_curved(site.problem.query.motion.space)) print_speed_up(results, "PRM*", "our parts", options.longest);
  std::fflush(stdout);
}

// Edges as a planner tries them: up to some metres long.
double edges_per_second(const Site& site, Parts parts) {
  og::SimpleSetup setup = site.setup(parts);
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
  const auto now = [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
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
}

void print_queries(const Site& site) {
  const double stock = edges_per_second(site, Parts::stock);
  const double ours = edges_per_second(site, Parts::ours);
  std::printf("%s: motionCost and checkMotion of an edge: stock %.0f a second, ours %.0f, %.1f times as many\n", site.name.c_str(), stock,
              ours, ours / stock);
  std::fflush(stdout);
}

PlanProblem on_shared_map(const std::filesystem::path& yaml, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
  PlanProblem problem{read_occupancy_map(yaml), {}, {}};
  problem.alignability = test::random_alignability(problem.occupancy.geometry(), 1);
  problem.query.robot.radius = 0.3;
  problem.query.start = {start.x(), start.y(), 0.0};
  problem.query.goal = {goal.x(), goal.y(), 0.0};
  return problem;
}

std::vector<Site> sites(const Options& options) {
  std::vector<Site> all;
  const auto add = [&](const std::string& name, PlanProblem problem, double yaw_of_cars_at_the_goal) {
    all.emplace_back(name + ", R²", problem, Motion{.space = MotionSpace::r2});
    all.emplace_back(name + ", SE(2)", problem, Motion{.space = MotionSpace::se2});
    problem.query.goal.yaw = yaw_of_cars_at_the_goal;
    all.emplace_back(name + ", Dubins", problem, Motion{.space = MotionSpace::dubins, .turning_radius = 1.5});
    all.emplace_back(name + ", Reeds-Shepp", problem, Motion{.space = MotionSpace::reeds_shepp, .turning_radius = 1.5});
  };
  add("the shipped warehouse", load_problem(read_problem_file("maps/warehouse/problem.yaml")), 0.0);
  const auto warehouse = options.shared / "maps/nav2/warehouse.yaml";
  const auto blocks = options.shared / "maps/nav2/100by100_10.yaml";
  if (std::filesystem::exists(warehouse)) {
    // What stands left of the goal is nearer than a car turns.
    add("nav2's warehouse, random alignability", on_shared_map(warehouse, {-5.0, -20.0}, {8.3, 18.0}), radians(90));
  }
  if (std::filesystem::exists(blocks)) add("random blocks, random alignability", on_shared_map(blocks, {7.5, 7.5}, {93.0, 93.0}), 0.0);
  return all;
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--seeds" && std::atoi(value) > 0) {
      options.seeds = static_cast<std::uint32_t>(std::atoi(value));
    } else if (name == "--longest" && std::atof(value) > 0.0) {
      options.longest = std::atof(value);
    } else if (name == "--shared" && *value != '\0') {
      options.shared = value;
    } else if (name == "--only" && *value != '\0') {
      options.only.emplace_back(value);
    } else if (name == "--site" && *value != '\0') {
      options.site = value;
    } else {
      std::fprintf(stderr, "usage: benchmark_planner [--seeds N] [--longest SECONDS] [--shared FOLDER] [--only NAME …] [--site TEXT]\n");
      std::exit(2);
    }
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const Options options = read_options(argc, argv);
  std::vector<Site> all = sites(options);
  std::erase_if(all, [&](const Site& site) { return site.name.find(options.site) == std::string::npos; });
  for (const Site& site : all) print_queries(site);
  for (const Site& site : all) print_costs(site, options);
}
