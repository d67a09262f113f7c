// SPDX-License-Identifier: BSD-3-Clause
#include "python/problem.hpp"

#include <limits>
#include <memory>
#include <numbers>

#include "python/bindings.hpp"
#include "python/keywords.hpp"

namespace alignability::python {
namespace {

// What a problem file allows.
constexpr Range kTurningRadius{.min = 0.0, .max = kWidestTurn, .min_end = Range::End::open};
constexpr Range kHeadingTolerance{.min = 0.0, .max = std::numbers::pi, .min_end = Range::End::open};
constexpr Range kCount{.min = 1.0, .max = std::numeric_limits<std::uint32_t>::max()};

void bind_robot(py::module_& module) {
  bind_options<Robot>(module, "Robot", "A disk of `radius` [m] around base_link, or the polygon of `footprint`, (x, y) in base_link [m].",
                      Keywords<Robot>()
                          .add(
                              "radius", kPositive, [](auto& o) -> auto& { return o.radius; })
                          .add(
                              "footprint", [](auto& o) -> auto& { return o.footprint; }));
}

void bind_motion(py::module_& module) {
  bind_options<Motion>(module, "Motion",
                       "How the robot moves: `space` is r2, se2, dubins or reeds_shepp; `turn_cost` [m/rad], `turning_radius` [m], "
                       "`reverse_penalty` what a metre backward costs more.",
                       Keywords<Motion>()
                           .add(
                               "space", [](auto& o) -> auto& { return o.space; })
                           .add(
                               "turn_cost", kNotNegative, [](auto& o) -> auto& { return o.turn_cost; })
                           .add(
                               "turning_radius", kTurningRadius, [](auto& o) -> auto& { return o.turning_radius; })
                           .add(
                               "reverse_penalty", kNotNegative, [](auto& o) -> auto& { return o.reverse_penalty; }));
}

void bind_goal_tolerance(py::module_& module) {
  bind_options<GoalTolerance>(module, "GoalTolerance", "Where a path may end: within `position` [m] and `heading` [rad] of the goal.",
                              Keywords<GoalTolerance>()
                                  .add(
                                      "position", kPositive, [](auto& o) -> auto& { return o.position; })
                                  .add(
                                      "heading", kHeadingTolerance, [](auto& o) -> auto& { return o.heading; }));
}

void bind_risk_options(py::module_& module) {
  bind_options<RiskOptions>(module, "RiskOptions",
                            "What is risky: 1 at `alpha_critical` and below, 0 at `alpha_safe` and above; `unknown` is risky, neutral or "
                            "blocked; where alpha is less than `min_alpha` the robot may not be; `alpha_weight` is its share of the sum "
                            "where a problem file has other sources.",
                            Keywords<RiskOptions>()
                                .add(
                                    "alpha_critical", kShare, [](auto& o) -> auto& { return o.alpha_critical; })
                                .add(
                                    "alpha_safe", kShare, [](auto& o) -> auto& { return o.alpha_safe; })
                                .add(
                                    "unknown", [](auto& o) -> auto& { return o.unknown; })
                                .add(
                                    "min_alpha", kShare, [](auto& o) -> auto& { return o.min_alpha; })
                                .add(
                                    "alpha_weight", kNotNegative, [](auto& o) -> auto& { return o.alpha_weight; }));
}

void bind_planner_choice(py::module_& module) {
  bind_options<PlannerChoice>(module, "PlannerChoice",
                              "Which planner (the best there is, without a name), and when it stops: after `iterations` where they are "
                              "given, else after `time` [s].",
                              Keywords<PlannerChoice>()
                                  .add(
                                      "name", [](auto& o) -> auto& { return o.name; })
                                  .add(
                                      "time", kPositive, [](auto& o) -> auto& { return o.time; })
                                  .add(
                                      "iterations", kCount, [](auto& o) -> auto& { return o.iterations; })
                                  .add(
                                      "seed", kCount, [](auto& o) -> auto& { return o.seed; }));
}

Keywords<PlanQuery> query_keywords() {
  return Keywords<PlanQuery>()
      .add(
          "robot", [](auto& o) -> auto& { return o.robot; })
      .add(
          "start", [](auto& o) -> auto& { return o.start; })
      .add(
          "goal", [](auto& o) -> auto& { return o.goal; })
      .add(
          "motion", [](auto& o) -> auto& { return o.motion; })
      .add(
          "goal_tolerance", [](auto& o) -> auto& { return o.goal_tolerance; })
      .add(
          "weight", kNotNegative, [](auto& o) -> auto& { return o.weight; })
      .add(
          "max_error", kPositive, [](auto& o) -> auto& { return o.max_error; })
      .add(
          "max_blind_distance", kNotNegative, [](auto& o) -> auto& { return o.max_blind_distance; })
      .add(
          "recovery_distance", kPositive, [](auto& o) -> auto& { return o.recovery_distance; })
      .add(
          "risk", [](auto& o) -> auto& { return o.risk; })
      .add(
          "planner", [](auto& o) -> auto& { return o.planner; });
}

// Files of what drives and localizes.
Keywords<ProblemFile> drive_keywords() {
  return Keywords<ProblemFile>()
      .add(
          "scene", [](auto& o) -> auto& { return o.scene; })
      .add(
          "sensor", [](auto& o) -> auto& { return o.sensor; })
      .add(
          "drive", [](auto& o) -> auto& { return o.drive; })
      .add(
          "range_max", kPositive, [](auto& o) -> auto& { return o.range_max; });
}

std::shared_ptr<Problem> load(const std::filesystem::path& path) {
  ProblemFile file = read_problem_file(path);
  PlanProblem plan = load_problem(file);
  return std::make_shared<Problem>(Problem{std::move(plan), std::move(file)});
}

std::shared_ptr<Problem> of_maps(const OccupancyMap& occupancy, const AlignabilityMap& alignability, const Robot& robot, const Pose2& start,
                                 const Pose2& goal, const py::kwargs& given) {
  PlanQuery query{.robot = robot, .motion = {}, .start = start, .goal = goal, .goal_tolerance = {}, .risk = {}, .planner = {}};
  query = query_keywords().read(std::move(query), given, "Problem");
  return std::make_shared<Problem>(Problem{{occupancy, alignability, std::move(query)}});
}

}  // namespace

void bind_problem(py::module_& module) {
  bind_robot(module);
  bind_motion(module);
  bind_goal_tolerance(module);
  bind_risk_options(module);
  bind_planner_choice(module);
  py::class_<Problem, std::shared_ptr<Problem>> bound(module, "Problem",
                                                      "What to plan: maps, the robot, start and goal, and what risk costs.");
  bound.def(py::init(&of_maps), py::arg("occupancy"), py::arg("alignability"), py::arg("robot"), py::arg("start"), py::arg("goal"),
            "Of maps, which are copied; all that can be set may be given as keywords.");
  bound.def_static("load", &load, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
                   "Reads a problem file and the maps that it names. Raises InputError.");
  bound.def(
      "copy", [](const Problem& problem) { return std::make_shared<Problem>(problem); }, "Another, to be set otherwise.");
  bound.def_property_readonly(
      "occupancy", [](const std::shared_ptr<Problem>& self) { return std::shared_ptr<OccupancyMap>(self, &self->plan.occupancy); });
  bound.def_property_readonly("alignability", [](const std::shared_ptr<Problem>& self) {
    return std::shared_ptr<AlignabilityMap>(self, &self->plan.alignability);
  });
  query_keywords().add_properties(bound, [](Problem& problem) -> PlanQuery& { return problem.plan.query; });
  drive_keywords().add_properties(bound, [](Problem& problem) -> ProblemFile& { return problem.file; });
}

}  // namespace alignability::python
