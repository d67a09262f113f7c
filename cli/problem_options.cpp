// SPDX-License-Identifier: BSD-3-Clause
#include "cli/problem_options.hpp"

#include <limits>
#include <stdexcept>

#include "planner/planners.hpp"

namespace alignability::cli {

void add_problem_options(CLI::App& command, ProblemOptions& options) {
  command.add_option("problem", options.file, "Problem file")->type_name("YAML")->required();
  command.add_option("--map", options.map, "Occupancy map in place of the file's")->type_name("YAML");
  command.add_option("--alignability", options.alignability, "Alignability map in place of the file's")->type_name("YAML");
  command.add_option("--planner", options.planner, "OMPL planner in place of the file's")->type_name("PLANNER");
  CLI::Option* time = command.add_option("--time", options.time, "Planning time [s]")->check(CLI::PositiveNumber);
  command.add_option("--iterations", options.iterations, "Planner iterations in place of a time")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{std::numeric_limits<std::uint32_t>::max()}))
      ->excludes(time);
  command.add_option("--seed", options.seed, "Seed of the planner")->check(CLI::Range(1u, std::numeric_limits<std::uint32_t>::max()));
  command.add_option("--weight", options.weight, "Weight of the risk; 0 plans the shortest path")->check(CLI::NonNegativeNumber);
  command.add_option("--start", options.start, "x,y,yaw [m, m, rad]")->expected(3)->delimiter(',');
  command.add_option("--goal", options.goal, "x,y,yaw [m, m, rad]")->expected(3)->delimiter(',');
}

ProblemFile problem_file(const ProblemOptions& options) {
  ProblemFile file = read_problem_file(options.file);
  file.map = options.map.value_or(file.map);
  if (options.alignability) file.alignability = {*options.alignability};
  PlanQuery& query = file.query;
  if (options.planner) {
    if (const auto refusal = refusal_of_planner(*options.planner)) throw std::invalid_argument(*refusal);
    query.planner.name = *options.planner;
  }
  if (options.time) query.planner.iterations.reset();
  query.planner.time = options.time.value_or(query.planner.time);
  if (options.iterations) query.planner.iterations = options.iterations;
  query.planner.seed = options.seed.value_or(query.planner.seed);
  query.weight = options.weight.value_or(query.weight);
  if (!options.start.empty()) query.start = {options.start[0], options.start[1], options.start[2]};
  if (!options.goal.empty()) query.goal = {options.goal[0], options.goal[1], options.goal[2]};
  if (const auto refusal = refusal_of_numbers(query)) throw std::invalid_argument(*refusal);
  return file;
}

PlanProblem load(const ProblemOptions& options) { return load_problem(problem_file(options)); }

}  // namespace alignability::cli
