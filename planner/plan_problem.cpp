// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan_problem.hpp"

#include <array>
#include <limits>
#include <sstream>

#include "core/range.hpp"
#include "core/yaml_map.hpp"
#include "costmap/heading_layers.hpp"
#include "costmap/map_server.hpp"
#include "costmap/scenario_map.hpp"
#include "planner/planners.hpp"
#include "planner/risk_sources_file.hpp"

namespace alignability {
namespace {

constexpr std::pair<const char*, MotionSpace> kSpaces[] = {
    {"r2", MotionSpace::r2}, {"se2", MotionSpace::se2}, {"dubins", MotionSpace::dubins}, {"reeds_shepp", MotionSpace::reeds_shepp}};
constexpr std::pair<const char*, UnknownPolicy> kPolicies[] = {
    {"risky", UnknownPolicy::risky}, {"neutral", UnknownPolicy::neutral}, {"blocked", UnknownPolicy::blocked}};

constexpr Range kTurningRadius{.min = 0.0, .max = kWidestTurn, .min_end = Range::End::open};

template <typename T, std::size_t N>
const char* name_of(T value, const std::pair<const char*, T> (&choices)[N]) {
  for (const auto& [name, choice] : choices) {
    if (choice == value) return name;
  }
  return "";
}

Pose2 read_pose(YamlMap& yaml, std::string_view key) {
  const auto values = yaml.numbers(key, 3, kFinite);
  return {values[0], values[1], values[2]};
}

Robot read_robot(YamlMap yaml) {
  Robot robot;
  if (const auto footprint = yaml.find_points("footprint", kFinite)) {
    if (yaml.has("radius")) yaml.fail("radius", "give 'radius' or 'footprint', not both");
    if (const auto fault = fault_of_footprint(*footprint)) yaml.fail("footprint", *fault);
    robot.footprint = *footprint;
  } else {
    robot.radius = yaml.number("radius", kPositive);
  }
  yaml.finish();
  return robot;
}

Motion read_motion(YamlMap yaml) {
  Motion motion;
  motion.space = yaml.find_choice("space", kSpaces).value_or(motion.space);
  motion.turn_cost = yaml.find_number("turn_cost", kCostWeights).value_or(motion.turn_cost);
  if (is_curved(motion.space)) {
    motion.turning_radius = yaml.number("turning_radius", kTurningRadius);
  } else if (yaml.has("turning_radius")) {
    yaml.fail("turning_radius", "a turning radius belongs to the spaces dubins and reeds_shepp");
  }
  if (yaml.has("reverse_penalty") && motion.space != MotionSpace::reeds_shepp) {
    yaml.fail("reverse_penalty", "only in the space reeds_shepp does the robot drive backward");
  }
  motion.reverse_penalty = yaml.find_number("reverse_penalty", kCostWeights).value_or(motion.reverse_penalty);
  yaml.finish();
  return motion;
}

GoalTolerance read_goal_tolerance(YamlMap yaml) {
  constexpr Range kAngle{.min = 0.0, .max = 180.0, .min_end = Range::End::open};
  GoalTolerance tolerance;
  tolerance.position = yaml.find_number("position", kPositive).value_or(tolerance.position);
  if (const auto heading = yaml.find_number("heading_deg", kAngle)) tolerance.heading = radians(*heading);
  yaml.finish();
  return tolerance;
}

void read_risk(YamlMap yaml, ProblemFile& file) {
  PlanQuery& query = file.query;
  query.weight = yaml.find_number("weight", kCostWeights).value_or(query.weight);
  query.max_error = yaml.find_number("max_error", kPositive);
  query.max_blind_distance = yaml.find_number("max_blind_distance", kNotNegative);
  query.recovery_distance = yaml.find_number("recovery_distance", kPositive).value_or(query.recovery_distance);
  query.risk.min_alpha = yaml.find_number("min_alignability", kShare);
  query.risk.alpha_critical = yaml.find_number("alpha_critical", kShare).value_or(query.risk.alpha_critical);
  query.risk.alpha_safe = yaml.find_number("alpha_safe", kShare).value_or(query.risk.alpha_safe);
  query.risk.unknown = yaml.find_choice("unknown", kPolicies).value_or(query.risk.unknown);
  if (const auto sources = yaml.find_map("sources")) {
    detail::RiskSources read = detail::read_risk_sources(*sources);
    query.risk.alpha_weight = read.alpha_weight;
    query.risk.sources = std::move(read.sources);
    file.raster_places = std::move(read.raster_places);
  }
  yaml.finish();
  if (query.risk.alpha_critical >= query.risk.alpha_safe) yaml.fail("alpha_critical", "'alpha_critical' must be less than 'alpha_safe'");
}

PlannerChoice read_planner(YamlMap yaml) {
  PlannerChoice choice;
  if (const auto name = yaml.find_text("name")) {
    if (const auto refusal = refusal_of_planner(*name)) yaml.fail("name", *refusal);
    choice.name = *name;
  }
  choice.time = yaml.find_number("time", kPositive).value_or(choice.time);
  choice.iterations = yaml.find_integer("iterations", 1, std::numeric_limits<std::uint32_t>::max());
  choice.seed = static_cast<std::uint32_t>(yaml.find_integer("seed", 1, std::numeric_limits<std::uint32_t>::max()).value_or(choice.seed));
  yaml.finish();
  if (choice.iterations && yaml.has("time")) yaml.fail("iterations", "give 'iterations' or 'time', not both");
  return choice;
}

std::string limits_of(const PlanQuery& query) {
  std::string limits;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) limits.append(", ").append(key).append(": ").append(to_text(*value));
  };
  add("max_error", query.max_error);
  add("min_alignability", query.risk.min_alpha);
  add("max_blind_distance", query.max_blind_distance);
  if (query.max_blind_distance) add("recovery_distance", query.recovery_distance);
  return limits;
}

std::string outline(const Robot& robot) {
  if (robot.footprint.empty()) return "radius: " + to_text(robot.radius);
  std::string corners;
  for (const Eigen::Vector2d& at : robot.footprint) {
    corners += (corners.empty() ? "[" : ", [") + to_text(at.x()) + ", " + to_text(at.y()) + ']';
  }
  return "footprint: [" + corners + ']';
}

std::string motion_text(const Motion& motion) {
  std::string text = "space: ";
  text += to_string(motion.space);
  text += ", turn_cost: " + to_text(motion.turn_cost);
  if (is_curved(motion.space)) text += ", turning_radius: " + to_text(motion.turning_radius);
  if (motion.space == MotionSpace::reeds_shepp) text += ", reverse_penalty: " + to_text(motion.reverse_penalty);
  return text;
}

std::vector<std::filesystem::path> read_alignability_paths(YamlMap& yaml) {
  if (!yaml.is_sequence("alignability")) return {yaml.path("alignability")};
  std::vector<std::filesystem::path> paths;
  for (const std::string& path : yaml.texts("alignability")) paths.push_back(yaml.file().parent_path() / path);
  if (paths.empty()) yaml.fail("alignability", "name at least one alignability map");
  return paths;
}

AlignabilityMap read_scenarios(const ProblemFile& file) {
  if (file.alignability.size() == 1) return read_alignability_map(file.alignability.front());
  std::vector<AlignabilityMap> maps;
  for (const std::filesystem::path& path : file.alignability) {
    maps.push_back(read_alignability_map(path));
    if (maps.back().geometry != maps.front().geometry) {
      throw InputError(path, "has another grid than " + file.alignability.front().string() + ", a scenario of the same site");
    }
    if (heading_layers(maps.back()).size() != heading_layers(maps.front()).size()) {
      throw InputError(path, "has other headings than " + file.alignability.front().string() + ", a scenario of the same site");
    }
  }
  return scenario_map(maps, file.scenario_quantile);
}

}  // namespace

ProblemFile read_problem_file(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  ProblemFile file;
  file.file = yaml_file;
  file.map = yaml.path("map");
  file.alignability = read_alignability_paths(yaml);
  if (auto scenarios = yaml.find_map("scenarios")) {
    file.scenario_quantile = scenarios->number("quantile", kShare);
    scenarios->finish();
  }
  file.scene = yaml.find_path("scene");
  file.sensor = yaml.find_path("sensor");
  file.range_max = yaml.find_number("range_max", kPositive);
  file.drive = yaml.find_path("drive");
  file.query.robot = read_robot(yaml.map("robot"));
  if (const auto motion = yaml.find_map("motion")) file.query.motion = read_motion(*motion);
  if (const auto refusal = refusal_of_space(file.query)) yaml.fail("motion", *refusal);
  file.query.start = read_pose(yaml, "start");
  file.query.goal = read_pose(yaml, "goal");
  if (const auto tolerance = yaml.find_map("goal_tolerance")) file.query.goal_tolerance = read_goal_tolerance(*tolerance);
  if (const auto risk = yaml.find_map("risk")) read_risk(*risk, file);
  if (const auto planner = yaml.find_map("planner")) file.query.planner = read_planner(*planner);
  if (const auto refusal = refusal_of_space(file.query)) yaml.fail("planner", *refusal);
  yaml.finish();
  return file;
}

PlanProblem load_problem(const ProblemFile& file) {
  PlanProblem problem{read_occupancy_map(file.map), read_scenarios(file), file.query};
  problem.query.risk.sources = detail::with_values(file, problem.occupancy);
  return problem;
}

const char* to_string(MotionSpace space) { return name_of(space, kSpaces); }

std::optional<std::string> refusal_of_numbers(const PlanQuery& query) {
  struct Number {
    const char* name;
    double value;
    const Range& allowed;
  };
  const PlannerChoice& planner = query.planner;
  const std::array numbers{
      Number{"a start's x", query.start.x, kFinite},
      Number{"a start's y", query.start.y, kFinite},
      Number{"a start's yaw", query.start.yaw, kFinite},
      Number{"a goal's x", query.goal.x, kFinite},
      Number{"a goal's y", query.goal.y, kFinite},
      Number{"a goal's yaw", query.goal.yaw, kFinite},
      Number{"the weight of the risk", query.weight, kCostWeights},
      Number{"what turning costs", query.motion.turn_cost, kCostWeights},
      Number{"a reverse penalty", query.motion.reverse_penalty, kCostWeights},
      Number{"the greatest error", query.max_error.value_or(1.0), kPositive},
      Number{"the blind distance", query.max_blind_distance.value_or(0.0), kNotNegative},
      Number{"the recovery distance", query.recovery_distance, kPositive},
      Number{"the planning time", planner.time, kPositive},
      Number{"the number of iterations", static_cast<double>(planner.iterations.value_or(1)), kPositive},
  };
  for (const Number& number : numbers) {
    if (number.allowed.contains(number.value)) continue;
    return std::string(number.name) + " must be " + number.allowed.description() + ", not " + to_text(number.value);
  }
  return std::nullopt;
}

std::optional<std::string> refusal_of_space(const PlanQuery& query) {
  const Motion& motion = query.motion;
  if (motion.space == MotionSpace::r2 && !query.robot.footprint.empty()) {
    return "a footprint has a heading, and the space r2 has none: take se2, or a radius";
  }
  if (!is_curved(motion.space)) return std::nullopt;
  if (!kTurningRadius.contains(motion.turning_radius)) return "a car's turning radius must be " + kTurningRadius.description() + " m";
  return refusal_of_planner(query.planner.name.empty() ? kDefaultPlanner : query.planner.name, motion.space);
}

std::string to_yaml(const PlanQuery& query) {
  const auto pose = [](const Pose2& p) { return '[' + to_text(p.x) + ", " + to_text(p.y) + ", " + to_text(p.yaw) + ']'; };
  std::ostringstream out;
  out << "robot: {" << outline(query.robot) << "}\n"
      << "motion: {" << motion_text(query.motion) << "}\n"
      << "start: " << pose(query.start) << "\ngoal: " << pose(query.goal) << '\n'
      << "goal_tolerance: {position: " << to_text(query.goal_tolerance.position)
      << ", heading_deg: " << to_text(degrees(query.goal_tolerance.heading)) << "}\n"
      << "risk: {weight: " << to_text(query.weight) << ", alpha_critical: " << to_text(query.risk.alpha_critical)
      << ", alpha_safe: " << to_text(query.risk.alpha_safe) << ", unknown: " << name_of(query.risk.unknown, kPolicies) << limits_of(query)
      << detail::sources_text(query.risk) << "}\n"
      << "planner: {name: " << (query.planner.name.empty() ? kDefaultPlanner : query.planner.name);
  if (query.planner.iterations) {
    out << ", iterations: " << *query.planner.iterations;
  } else {
    out << ", time: " << to_text(query.planner.time);
  }
  out << ", seed: " << query.planner.seed << "}\n";
  return out.str();
}

}  // namespace alignability
