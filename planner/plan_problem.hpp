// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/input_error.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/occupancy_map.hpp"
#include "costmap/risk_field.hpp"
#include "planner/pose_goal.hpp"
#include "planner/robot.hpp"

namespace alignability {

enum class MotionSpace {
  r2,
  se2,
  dubins,       ///< a car that drives forward alone
  reeds_shepp,  ///< a car that drives backward too
};

/// The name of a space as problem files have it.
const char* to_string(MotionSpace space);

/// Whether its motions are a car's, curves of arcs and straights.
constexpr bool is_curved(MotionSpace space) { return space == MotionSpace::dubins || space == MotionSpace::reeds_shepp; }

struct Motion {
  MotionSpace space = MotionSpace::se2;
  double turn_cost = 0.2;        ///< [m/rad], >= 0; without effect in R²
  double turning_radius = 0.0;   ///< of `base_link` [m], in (0, kWidestTurn]; of curved spaces, in which there is no default
  double reverse_penalty = 1.0;  ///< >= 0; what a metre costs more when driven backward, of reeds_shepp alone
};

/// The greatest turning radius [m]: beyond it OMPL's words and rounding get in one another's way.
inline constexpr double kWidestTurn = 1000.0;

/// Which planner, and when it stops: after `iterations` when they are given, else after `time`.
struct PlannerChoice {
  std::string name;                          ///< one of planner_names(); empty: kDefaultPlanner
  double time = 2.0;                         ///< [s], > 0, for the whole search; but for iterations kept to within a tenth
  std::optional<std::int64_t> iterations{};  ///< samples, roughly: planners count differently
  std::uint32_t seed = 1;                    ///< >= 1
};

/// What to plan, but for the maps.
struct PlanQuery {
  Robot robot;
  Motion motion;
  Pose2 start;
  Pose2 goal;
  GoalTolerance goal_tolerance;
  double weight = 5.0;  ///< of the risk, of all its sources together, from 0 to 1e9
  /// The 95th percentile of the localization error that may be predicted anywhere on the path [m], > 0; comparisons pay no heed to it.
  std::optional<double> max_error = {};
  /// How many blind metres there may be between one place where the robot finds itself and the next (see BlindLimit) [m], >= 0; likewise.
  std::optional<double> max_blind_distance = {};
  double recovery_distance = 1.0;  ///< safe metres on which it finds itself, > 0
  RiskOptions risk;
  PlannerChoice planner;
};

struct PlanProblem {
  OccupancyMap occupancy;
  AlignabilityMap alignability;
  PlanQuery query;
};

/// A problem file as the README has it, the files that it names not yet read. Their paths are resolved against its folder.
struct ProblemFile {
  std::filesystem::path map;
  std::vector<std::filesystem::path> alignability;  ///< at least one; several are scenarios of one site
  double scenario_quantile = 0.0;                   ///< of several, what counts of a cell (see scenario_map)
  std::optional<std::filesystem::path> scene;
  std::optional<std::filesystem::path> sensor;
  std::optional<double> range_max;
  std::optional<std::filesystem::path> drive;
  PlanQuery query;                          ///< the sources of its risk without their values
  std::filesystem::path file;               ///< that all this is from
  std::vector<TextPosition> raster_places;  ///< where it names the raster of each of these sources
};

/// Throws InputError.
ProblemFile read_problem_file(const std::filesystem::path& yaml_file);

/// Reads the maps. Throws InputError.
PlanProblem load_problem(const ProblemFile& file);

/// Which of a query's numbers is out of range, those of its robot and goal tolerance left out; nullopt when none is.
std::optional<std::string> refusal_of_numbers(const PlanQuery& query);

/// Why a query's robot cannot be planned for in its space, by its planner; nullopt when it can.
std::optional<std::string> refusal_of_space(const PlanQuery& query);

/// The query as the lines of a problem file, defaults written out.
std::string to_yaml(const PlanQuery& query);

}  // namespace alignability
