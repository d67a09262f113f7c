// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_plan.hpp"

#include <algorithm>

#include "planner/car_path.hpp"
#include "planner/limited_path.hpp"
#include "planner/planar_plan.hpp"
#include "planner/planners.hpp"
#include "planner/refused_planners.hpp"

namespace alignability {
namespace {

// Vertices that are added to a path shift the steps by which its error is predicted: by so much less than the limit the search keeps,
// the next where that was not enough.
constexpr double kStricter[] = {0.999, 0.99, 0.95};

// What a solved plan is to be replaced for: the same query within its limits.
struct Limited {
  const PlanResult& free;
  const std::optional<ErrorModel>& model;
  const DrivableArea& area;
  const AlignabilityObjective& objective;
  const StopTest& stop;

  const PlanQuery& query() const { return free.query; }
  bool is_car() const { return objective.steering() != nullptr; }
  PathLimits limits(double stricter) const {
    PathLimits limits;
    if (query().max_error) limits.error = ErrorLimit{*model, stricter * *query().max_error};
    if (query().max_blind_distance) limits.blind = BlindLimit{*query().max_blind_distance, query().recovery_distance};
    return limits;
  }
  PlanarMotion motion() const { return {area.risk_field(), area.clearance_map(), query().weight, area.circumscribed_radius()}; }
  CarTask car_task(const PathLimits& limits) const {
    return {area, objective, query().start, query().goal, query().goal_tolerance, limits};
  }
  // Short of the tolerance by as much as the path is cut.
  LimitedWay way() const { return {query().start.position(), query().goal.position(), (1.0 - 1e-6) * query().goal_tolerance.position}; }
};

// How far it errs, and how blind it gets.
PlanResult with_states(PlanResult result, const std::optional<ErrorModel>& model, const RiskField& risk) {
  const bool is_car = !result.curves.empty();
  const double recovery = result.query.recovery_distance;
  if (model) {
    result.predicted_error =
        is_car ? greatest_predicted_error(result.curves, risk, *model) : greatest_predicted_error(result.path, risk, *model);
  }
  if (result.query.max_blind_distance) {
    result.longest_unrecovered =
        is_car ? longest_unrecovered(result.curves, risk, recovery) : longest_unrecovered(result.path, risk, recovery);
  }
  return result;
}

bool keeps_error(const PlanResult& result) { return !result.query.max_error || *result.predicted_error <= *result.query.max_error; }

bool keeps_blind_distance(const PlanResult& result) {
  return !result.query.max_blind_distance || *result.longest_unrecovered <= *result.query.max_blind_distance + BlindLimit::kRounding;
}

PlanResult solved_by_car(const std::vector<Pose2>& poses, const Limited& limited) {
  PlanResult result;
  result.status = PlanStatus::solved;
  result.query = limited.query();
  result.curves = curves_through(poses, *limited.objective.steering());
  result.path = driven_poses(result.curves, limited.area);
  for (const Curve& curve : result.curves) result.cost += limited.objective.cost_of(curve);
  result.figures = measure(result.curves, *limited.area.risk_field());
  return result;
}

std::optional<PlanResult> plan_within(const Limited& limited, const PathLimits& limits) {
  if (limited.is_car()) {
    const auto poses = car_path(limited.car_task(limits), limited.stop);
    return poses ? std::optional(solved_by_car(*poses, limited)) : std::nullopt;
  }
  const auto path = path_within(limited.motion(), limits, limited.way(), limited.stop);
  return path ? std::optional(solved_along(*path, limited.query(), *limited.area.risk_field())) : std::nullopt;
}

using SmallestLimit = std::optional<double> (*)(const PlanarMotion&, const PathLimits&, const LimitedWay&, const StopTest&);

// nullopt where the time does not suffice. Of a car nothing is sought: that a search of all its poses finds none takes too long to ask
// again and again.
std::optional<double> smallest_in_time(const Limited& limited, SmallestLimit smallest) {
  if (limited.is_car()) return std::nullopt;
  try {
    return smallest(limited.motion(), limited.limits(1.0), limited.way(), limited.stop);
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

// What was found, or what the free plan comes to where that does and is less.
std::optional<double> smaller(const std::optional<double>& found, bool free_does, double free) {
  return free_does ? std::min(found.value_or(free), free) : found;
}

PlanResult infeasible(const Limited& limited) {
  PlanResult none;
  none.status = PlanStatus::infeasible;
  none.query = limited.query();
  none.lower_bound = limited.free.lower_bound;
  if (none.query.max_error) {
    auto smallest = smallest_in_time(limited, smallest_max_error);
    if (smallest) *smallest /= kStricter[0];
    none.smallest_max_error = smaller(smallest, keeps_blind_distance(limited.free), *limited.free.predicted_error);
  }
  if (none.query.max_blind_distance) {
    none.smallest_max_blind_distance =
        smaller(smallest_in_time(limited, smallest_max_blind_distance), keeps_error(limited.free), *limited.free.longest_unrecovered);
  }
  return none;
}

}  // namespace

std::optional<std::string> refusal_of_limit(const PlanQuery& query, const std::optional<ErrorModel>& model) {
  if (!query.max_error && !query.max_blind_distance) return std::nullopt;
  if (query.max_error && !model) return "a limit of the error needs an alignability map with an error model: 'calibrate' makes one";
  if (query.planner.name == kDefaultPlanner) return std::nullopt;
  return std::string(query.max_error ? "a limit of the error" : "a limit of blind metres") + " is kept by the planner '" + kDefaultPlanner +
         "' alone";
}

std::optional<std::string> refusal_by_headings(const PlanQuery& query, const RiskField& risk) {
  if (!risk.has_headings() || is_curved(query.motion.space)) return std::nullopt;
  if (query.max_error || query.max_blind_distance) {
    const std::string limit = query.max_error ? "a limit of the error" : "a limit of blind metres";
    return limit + " is kept by heading in dubins and reeds_shepp alone, and this alignability map has layers by heading";
  }
  const char* reason = reason_against(query.planner.name, MotionSpace::dubins);
  if (query.motion.space != MotionSpace::r2 || reason == nullptr) return std::nullopt;
  return "the planner '" + query.planner.name + "' is not offered in r2 where alignability depends on the direction of travel: " + reason;
}

PlanResult within_limit(PlanResult result, const std::optional<ErrorModel>& model, const DrivableArea& area,
                        const AlignabilityObjective& objective, const StopTest& stop) {
  result = with_states(std::move(result), model, *area.risk_field());
  if (keeps_error(result) && keeps_blind_distance(result)) return result;
  const Limited limited{result, model, area, objective, stop};
  for (const double stricter : kStricter) {
    auto within = plan_within(limited, limited.limits(stricter));
    if (!within) break;
    within = with_states(std::move(*within), model, *area.risk_field());
    within->lower_bound = result.lower_bound;
    if (keeps_error(*within) && keeps_blind_distance(*within)) return *within;
    if (!result.query.max_error) break;
  }
  return infeasible(limited);
}

}  // namespace alignability
