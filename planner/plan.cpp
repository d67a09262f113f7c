// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan.hpp"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <stdexcept>

#include "planner/alignability_objective.hpp"
#include "planner/alpha_floor.hpp"
#include "planner/car_path.hpp"
#include "planner/drivability.hpp"
#include "planner/dubins_space.hpp"
#include "planner/headings.hpp"
#include "planner/limited_plan.hpp"
#include "planner/path_shortening.hpp"
#include "planner/planners.hpp"
#include "planner/poses.hpp"
#include "planner/time_limit.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

class Stopwatch {
 public:
  explicit Stopwatch(double already = 0.0) : already_(already) {}

  double seconds() const { return already_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double already_;  // [s]
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// OMPL seeds anew and repeats exactly, but logs an error whenever generators exist already.
void seed_ompl(std::uint32_t seed) {
  ompl::msg::OutputHandler* handler = ompl::msg::getOutputHandler();
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(seed);
  ompl::msg::useOutputHandler(handler);
}

// In R² facing anywhere.
bool may_be_at(const Pose2& pose, const PlanQuery& query, const DrivableArea& area) {
  return query.motion.space == MotionSpace::r2 ? area.contains_disk(pose.position()) : area.contains(pose);
}

// But for the floor of α.
std::optional<PlanStatus> refusal_by_obstacles(const PlanQuery& query, const DrivableArea& area, const StopTest& stop) {
  if (!area.geometry().cell_near(query.start.position())) return PlanStatus::start_outside_map;
  if (!area.geometry().cell_near(query.goal.position())) return PlanStatus::goal_outside_map;
  if (!may_be_at(query.start, query, area)) return PlanStatus::start_in_collision;
  if (!may_be_at(query.goal, query, area)) return PlanStatus::goal_in_collision;
  if (!area.may_connect(query.start, query.goal, query.goal_tolerance.position, stop)) return PlanStatus::no_path;
  return std::nullopt;
}

std::optional<PlanStatus> refusal(const PlanQuery& query, const DrivableArea& area, const StopTest& stop) {
  const auto& floor = area.risk_field()->options().min_alpha;
  if (!floor) return refusal_by_obstacles(query, area, stop);
  const auto risk = std::make_shared<const RiskField>(area.risk_field()->with_floor(std::nullopt));
  if (const auto refused = refusal_by_obstacles(query, DrivableArea(area.clearance_map(), risk, query.robot), stop)) return refused;
  const PlanarMotion motion{risk, area.clearance_map(), query.weight, area.inscribed_radius()};
  const auto greatest = greatest_alpha_floor(motion, query.start.position(), query.goal.position(), stop);
  return greatest && *greatest >= *floor ? std::nullopt : std::optional(PlanStatus::infeasible);
}

// As OMPL's, but that planners are to check the way back on its own: of two words as short it may be another.
class OneWayReedsSheppSpace : public ob::ReedsSheppStateSpace {
 public:
  using ob::ReedsSheppStateSpace::ReedsSheppStateSpace;
  bool hasSymmetricInterpolate() const override { return false; }
};

template <typename Space, typename Bounds>
ob::StateSpacePtr bounded(std::shared_ptr<Space> space, const Bounds& bounds) {
  space->setBounds(bounds);
  return space;
}

ob::StateSpacePtr make_space(const Motion& motion, const GridGeometry& map) {
  ob::RealVectorBounds bounds(2);
  for (const unsigned int axis : {0u, 1u}) {
    bounds.setLow(axis, map.origin[axis]);
    bounds.setHigh(axis, map.upper_corner()[axis]);
  }
  switch (motion.space) {
    case MotionSpace::r2:
      return bounded(std::make_shared<ob::RealVectorStateSpace>(2), bounds);
    case MotionSpace::se2:
      return bounded(std::make_shared<ob::SE2StateSpace>(), bounds);
    case MotionSpace::dubins:
      return bounded(std::make_shared<DubinsSpace>(motion.turning_radius), bounds);
    case MotionSpace::reeds_shepp:
      return bounded(std::make_shared<OneWayReedsSheppSpace>(motion.turning_radius), bounds);
  }
  return nullptr;
}

ob::SpaceInformationPtr make_space_information(const PlanQuery& query, const DrivableArea& area) {
  const auto si = std::make_shared<ob::SpaceInformation>(make_space(query.motion, area.geometry()));
  si->setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
  si->setMotionValidator(motion_validator_for(si, area));
  si->setup();
  return si;
}

ob::ProblemDefinitionPtr make_definition(const PlanQuery& query, const ob::SpaceInformationPtr& si,
                                         const ob::OptimizationObjectivePtr& objective) {
  const auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> start(si);
  set_pose(*si->getStateSpace(), query.start, start.get());
  definition->addStartState(start);
  definition->setGoal(std::make_shared<PoseGoal>(si, query.goal, query.goal_tolerance));
  definition->setOptimizationObjective(objective);
  return definition;
}

ob::PlannerTerminationCondition until(const PlannerChoice& choice, const StopTest& stop) {
  if (!choice.iterations || counts_its_own_iterations(choice.name)) return ob::PlannerTerminationCondition(stop);
  // OMPL's own counter is no atomic, and CForest and PRM ask from several threads.
  const auto asked = std::make_shared<std::atomic<std::int64_t>>(0);
  return ob::PlannerTerminationCondition([stop, asked, limit = *choice.iterations] { return stop() || asked->fetch_add(1) >= limit; });
}

// CForest gives its path in a wrapper of the space.
og::PathGeometric in_space(const ob::SpaceInformationPtr& si, og::PathGeometric& path) {
  og::PathGeometric own(si);
  for (const ob::State* state : path.getStates()) own.append(state);
  return own;
}

std::vector<Pose2> poses_of(const og::PathGeometric& path, const PlanQuery& query, const RiskField& risk) {
  const StateProjection projection = projection_of(path.getSpaceInformation()->getStateSpace());
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) poses.push_back(projection(path.getState(static_cast<unsigned int>(i))));
  // A path in R² has no heading of its own: the robot looks where it goes.
  if (query.motion.space != MotionSpace::r2) return poses;
  poses = looking_ahead(std::move(poses), query.start.yaw);
  return risk.has_headings() ? turning_on_the_spot(poses) : poses;
}

std::vector<Curve> curves_of(const og::PathGeometric& path, const Steering& steering) {
  const StateProjection projection = projection_of(path.getSpaceInformation()->getStateSpace());
  std::vector<Pose2> poses;
  for (unsigned int i = 0; i < path.getStateCount(); ++i) poses.push_back(projection(path.getState(i)));
  return curves_through(poses, steering);
}

// What is said of a path that the planner found.
void describe(PlanResult& result, og::PathGeometric& path, const ob::OptimizationObjectivePtr& objective, const Steering* steering,
              const DrivableArea& area) {
  const RiskField& risk = *area.risk_field();
  result.status = PlanStatus::solved;
  result.path = poses_of(path, result.query, risk);
  result.cost = path.cost(objective).value();
  if (steering != nullptr) result.curves = curves_of(path, *steering);
  if (!result.curves.empty()) result.path = driven_poses(result.curves, area);
  result.figures = result.curves.empty() ? measure(result.path, risk) : measure(result.curves, risk);
}

og::PathGeometric standing_path(const ob::ProblemDefinition& definition) {
  return og::PathGeometric(definition.getSpaceInformation(), definition.getStartState(0));
}

// The planner's path, shortened; nullopt when it found none.
std::optional<og::PathGeometric> solve(const PlanQuery& query, const detail::TimeLimit& limit, const ob::ProblemDefinitionPtr& definition,
                                       const Stopwatch& watch, PlanResult& result) {
  if (definition->getGoal()->isSatisfied(definition->getStartState(0))) {
    result.first_solution_seconds = watch.seconds();
    return standing_path(*definition);
  }
  const bool tells = reports_its_first_solution(query.planner.name);
  std::mutex first_mutex;  // some planners search in several threads
  const auto note_first = [&] {
    const std::lock_guard lock(first_mutex);
    if (!result.first_solution_seconds && tells) result.first_solution_seconds = watch.seconds();
  };
  if (tells) {
    definition->setIntermediateSolutionCallback(
        [&](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost) { note_first(); });
  }
  const ob::PlannerPtr planner = make_planner(query.planner, definition->getSpaceInformation());
  planner->setProblemDefinition(definition);
  planner->setup();
  const ob::PlannerStatus status = planner->solve(until(query.planner, limit.search()));
  definition->setIntermediateSolutionCallback({});
  if (status != ob::PlannerStatus::EXACT_SOLUTION) {
    result.first_solution_seconds.reset();
    return std::nullopt;
  }
  note_first();
  og::PathGeometric found = in_space(definition->getSpaceInformation(), *definition->getSolutionPath()->as<og::PathGeometric>());
  // A planner that takes a motion for one that can be driven back may find what cannot be driven.
  if (is_curved(query.motion.space) && !found.check()) {
    result.first_solution_seconds.reset();
    return std::nullopt;
  }
  return shortened(found, *definition, limit.afterwards());
}

double least_turning(const PlanQuery& query) {
  if (query.motion.space == MotionSpace::r2) return 0.0;
  const double turn = std::abs(normalized_angle(query.goal.yaw - query.start.yaw)) - query.goal_tolerance.heading;
  return query.motion.turn_cost * std::max(0.0, turn);
}

// Of the way in the plane: by the bounds that the search goes by, or by one for the way to the goal alone, made while it runs; where there
// is no time for that, its straight length.
std::future<double> least_along(const PlanQuery& query, const DrivableArea& area, const std::shared_ptr<const RouteBounds>& bounds,
                                const StopTest& stop) {
  return std::async(bounds ? std::launch::deferred : std::launch::async, [&query, &area, bounds, stop] {
    const Eigen::Vector2d start = query.start.position();
    const Eigen::Vector2d goal = query.goal.position();
    if (bounds) return bounds->to_goal(start);
    try {
      const auto lattice =
          std::make_shared<const CostLattice>(*area.risk_field(), *area.clearance_map(), query.weight, area.inscribed_radius(), stop);
      return CostBound(lattice, goal, query.goal_tolerance.position, stop)(start);
    } catch (const Interrupted&) {
      return std::max(0.0, (goal - start).norm() - query.goal_tolerance.position);
    }
  });
}

// Of floors at which there may be a way, the first of a few, from the greatest down, with which a path is found in what time is left.
std::optional<double> floor_with_a_path(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options,
                                        const StopTest& stop) {
  constexpr double kLower[] = {0.0, 0.002, 0.01, 0.03, 0.1, 0.2};
  const PlanarMotion motion{fields.risk, fields.clearance, query.weight, inscribed_radius(query.robot)};
  const auto greatest = greatest_alpha_floor(motion, query.start.position(), query.goal.position(), stop);
  if (!greatest) return std::nullopt;
  PlanQuery lower = query;
  lower.max_error.reset();
  lower.max_blind_distance.reset();
  lower.planner = {.name = kDefaultPlanner, .time = 0.2};
  for (const double by : kLower) {
    PlanningFields lowered = fields;
    const double floor = std::floor(1000.0 * (*greatest - by)) / 1000.0;
    if (floor < 0.0 || stop()) break;
    lowered.risk = std::make_shared<const RiskField>(fields.risk->with_floor(floor));
    if (plan(lower, lowered, options).status == PlanStatus::solved) return floor;
  }
  return std::nullopt;
}

// What `result`, of the same query, becomes. Throws Interrupted where the time is over before there is a path, or one within the limits.
PlanResult solved_in_time(PlanResult result, const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options,
                          const Stopwatch& watch) {
  const detail::TimeLimit limit(result.query.planner, options.stop);
  const DrivableArea area(fields.clearance, fields.risk, query.robot);
  if (const auto refused = refusal(query, area, limit.search())) {
    result.status = *refused;
    if (*refused == PlanStatus::infeasible) result.greatest_min_alpha = floor_with_a_path(query, fields, options, limit.search());
    return result;
  }
  seed_ompl(query.planner.seed);
  const auto si = make_space_information(query, area);
  const auto objective = std::make_shared<AlignabilityObjective>(
      si, fields.risk, ObjectiveOptions{query.weight, query.motion.turn_cost, query.motion.reverse_penalty});
  const auto definition = make_definition(query, si, objective);
  if (gains_from_bounds(result.query.planner.name)) {
    objective->set_bounds(std::make_shared<const RouteBounds>(area, query.weight, query.start.position(), query.goal.position(),
                                                              query.goal_tolerance.position, limit.search()));
  }
  std::future<double> least = least_along(query, area, objective->bounds(), limit.afterwards());
  auto path = solve(result.query, limit, definition, watch, result);
  if (options.stop.stop_requested()) throw Interrupted();
  result.lower_bound = least.get() + least_turning(query);
  if (!path) return result;
  describe(result, *path, objective, objective->steering(), area);
  return within_limit(std::move(result), fields.error_model, area, *objective, limit.search());
}

}  // namespace

const char* to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::solved:
      return "solved";
    case PlanStatus::no_path:
      return "no_path";
    case PlanStatus::timeout:
      return "timeout";
    case PlanStatus::infeasible:
      return "infeasible";
    case PlanStatus::start_in_collision:
      return "start_in_collision";
    case PlanStatus::goal_in_collision:
      return "goal_in_collision";
    case PlanStatus::start_outside_map:
      return "start_outside_map";
    case PlanStatus::goal_outside_map:
      return "goal_outside_map";
    case PlanStatus::interrupted:
      return "interrupted";
  }
  return "";
}

PlanningFields::PlanningFields(const PlanProblem& problem) {
  const Stopwatch watch;
  risk = std::make_shared<const RiskField>(problem.alignability, problem.occupancy, problem.query.risk);
  clearance = std::make_shared<const ClearanceMap>(problem.occupancy);
  error_model = problem.alignability.error_model;
  seconds = watch.seconds();
}

PlanResult plan(const PlanQuery& query, const PlanningFields& fields, const PlanOptions& options) {
  const Stopwatch watch(fields.seconds);
  PlanResult result;
  result.query = query;
  result.query.risk = fields.risk->options();
  if (query.planner.name.empty()) result.query.planner.name = kDefaultPlanner;
  if (const auto unfit = refusal_of_numbers(query)) throw std::invalid_argument(*unfit);
  if (const auto unfit = refusal_of_space(query)) throw std::invalid_argument(*unfit);
  if (const auto unfit = refusal_of_planner(result.query.planner.name)) throw std::invalid_argument(*unfit);
  if (const auto unfit = refusal_of_limit(result.query, fields.error_model)) throw std::invalid_argument(*unfit);
  if (const auto unfit = refusal_by_headings(result.query, *fields.risk)) throw std::invalid_argument(*unfit);
  const PlanResult nothing = result;
  try {
    result = solved_in_time(nothing, query, fields, options, watch);
  } catch (const Interrupted&) {  // by the time, unless told to stop
  }
  if (options.stop.stop_requested()) {
    result = nothing;
    result.status = PlanStatus::interrupted;
  }
  result.seconds = watch.seconds();
  return result;
}

PlanResult plan(const PlanProblem& problem, const PlanOptions& options) { return plan(problem.query, PlanningFields(problem), options); }

}  // namespace alignability
