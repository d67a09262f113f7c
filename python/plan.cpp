// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan.hpp"

#include <chrono>
#include <memory>
#include <mutex>

#include "core/range.hpp"
#include "planner/compare.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/casters.hpp"
#include "python/long_work.hpp"
#include "python/problem.hpp"

namespace alignability::python {
namespace {

// OMPL's seed is the whole process's, so that threads of Python plan one after the other.
std::unique_lock<std::timed_mutex> turn_to_plan(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kPatience(50);
  static std::timed_mutex one_at_a_time;
  std::unique_lock lock(one_at_a_time, std::defer_lock);
  while (!lock.try_lock_for(kPatience)) {
    if (stop.stop_requested()) throw Interrupted();
  }
  return lock;
}

PlanResult plan_problem(const Problem& problem) {
  const PlanProblem given = problem.plan;  // as it is now, whatever other threads set meanwhile
  return LongWork().run([&](const std::stop_token& stop) {
    const auto lock = turn_to_plan(stop);
    return plan(given, {.stop = stop});
  });
}

Comparison compare_problem(const Problem& problem) {
  const PlanProblem given = problem.plan;
  return LongWork().run([&](const std::stop_token& stop) {
    const auto lock = turn_to_plan(stop);
    return compare(given, {.stop = stop});
  });
}

bool is_solved(const PlanResult& result) { return result.status == PlanStatus::solved; }

py::dict risk_by_source(const PlanResult& result) {
  py::dict risks;
  const std::vector<std::string> names = names_of_risks(result.query.risk);
  for (std::size_t i = 0; i < names.size() && i < result.figures.risk_by_source.size(); ++i) {
    risks[py::str(names[i])] = result.figures.risk_by_source[i];
  }
  return risks;
}

std::string shown(const PlanResult& result) {
  std::string text("<PlanResult ");
  text.append(to_string(result.status));
  if (is_solved(result)) text.append(", ").append(fixed_text(result.figures.length, 2)).append(" m");
  return text.append(">");
}

void bind_figures(py::module_& module) {
  py::class_<PathFigures>(module, "PathFigures", "What a path is worth: lengths in metres, exactly.")
      .def_readonly("length", &PathFigures::length)
      .def_readonly("turned", &PathFigures::turned, "[rad].")
      .def_readonly("backward_length", &PathFigures::backward_length)
      .def_readonly("risk_integral", &PathFigures::risk_integral)
      .def_readonly("blind_length", &PathFigures::blind_length)
      .def_readonly("longest_blind", &PathFigures::longest_blind)
      .def_readonly("evaluated_length", &PathFigures::evaluated_length)
      .def_readonly("alpha_mean", &PathFigures::alpha_mean, "By length; NaN where nothing is evaluated.")
      .def_readonly("alpha_min", &PathFigures::alpha_min, "Likewise.")
      .def("__repr__", [](const PathFigures& figures) {
        return "<PathFigures length " + fixed_text(figures.length, 2) + " m, blind " + fixed_text(figures.blind_length, 2) + " m>";
      });
}

void bind_result(py::module_& module) {
  py::class_<PlanResult> bound(module, "PlanResult", "A path, or why there is none.");
  const auto of_a_path = [&bound](const char* name, auto value, const char* doc) {
    using Value = std::invoke_result_t<decltype(value), const PlanResult&>;
    bound.def_property_readonly(
        name, [value](const PlanResult& result) { return is_solved(result) ? std::optional<Value>(value(result)) : std::nullopt; }, doc);
  };
  bound.def_property_readonly(
      "status", [](const PlanResult& result) { return to_string(result.status); },
      "solved, no_path, timeout, infeasible, start_in_collision, goal_in_collision, start_outside_map or "
      "goal_outside_map.");
  bound.def_property_readonly("solved", &is_solved);
  bound.def_property_readonly(
      "poses", [](const py::object& self) { return view_of(self.cast<const PlanResult&>().path, self); },
      "(N, 3) of x, y [m], yaw [rad], straight between; a view, not to be written to. Empty unless solved.");
  of_a_path(
      "cost", [](const PlanResult& result) { return result.cost; }, "[equivalent m]; None unless solved.");
  of_a_path(
      "figures", [](const PlanResult& result) { return result.figures; }, "None unless solved.");
  of_a_path("risk_by_source", &risk_by_source, "By name the metres at each risk, unweighted; None unless solved.");
  bound.def_readonly("lower_bound", &PlanResult::lower_bound, "No path costs less; None where no bound was sought.")
      .def_readonly("predicted_error", &PlanResult::predicted_error, "[m]; None of a map without an error model.")
      .def_readonly("longest_unrecovered", &PlanResult::longest_unrecovered, "[m]; None without a limit of it.")
      .def_readonly("smallest_max_error", &PlanResult::smallest_max_error, "Of an infeasible problem: a limit that a path keeps.")
      .def_readonly("smallest_max_blind_distance", &PlanResult::smallest_max_blind_distance, "Likewise.")
      .def_readonly("greatest_min_alpha", &PlanResult::greatest_min_alpha, "Likewise.")
      .def_readonly("seconds", &PlanResult::seconds)
      .def_readonly("first_solution_seconds", &PlanResult::first_solution_seconds)
      .def_property_readonly("planner", [](const PlanResult& result) { return result.query.planner.name; })
      .def_property_readonly("seed", [](const PlanResult& result) { return result.query.planner.seed; })
      .def_property_readonly("weight", [](const PlanResult& result) { return result.query.weight; })
      .def("__repr__", &shown);
}

}  // namespace

void bind_plan(py::module_& module) {
  bind_figures(module);
  bind_result(module);
  py::class_<Comparison>(module, "Comparison", "The same problem planned for length alone and for the risk too.")
      .def_readonly("shortest", &Comparison::shortest)
      .def_readonly("risk_aware", &Comparison::risk_aware)
      .def_property_readonly("solved", &solved, "Whether both are.")
      .def_property_readonly(
          "length_ratio", [](const Comparison& c) { return solved(c) ? std::optional(length_ratio(c)) : std::nullopt; },
          "Of the risk-aware path's length to the shortest one's; None unless both are solved.");
  module.def("plan", &plan_problem, py::arg("problem"),
             "Plans the problem as it is now. One plan at a time in a process, others wait: OMPL's seed is the process's. Ctrl-C stops it. "
             "Raises ValueError for what cannot be planned so.");
  module.def("compare", &compare_problem, py::arg("problem"), "Plans it for length alone, weight 0, and for its weight; see plan.");
}

}  // namespace alignability::python
