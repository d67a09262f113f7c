// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "planner/plan_problem.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

constexpr const char* kGood =
    "map: maps/hall.yaml\n"
    "alignability: hall_alignability.yaml\n"
    "robot: {radius: 0.6}\n"
    "motion: {space: r2, turn_cost: 0.3}\n"
    "start: [1, 2, 0.5]\n"
    "goal: [3, 4, -0.5]\n"
    "goal_tolerance: {position: 0.2, heading_deg: 90}\n"
    "risk: {weight: 7, alpha_critical: 0.2, alpha_safe: 0.5, unknown: neutral}\n"
    "planner: {name: prmstar, time: 3.5, seed: 9}\n"
    "scene: hall.sdf\n"
    "sensor: ../sensors/hdl32e.yaml\n"
    "range_max: 6.5\n";

class ProblemFileTest : public testing::Test {
 protected:
  ProblemFile read(const std::string& text) const {
    write_file(file, text);
    return read_problem_file(file);
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder / "problem.yaml";
};

TEST_F(ProblemFileTest, ReadsEveryKey) {
  const ProblemFile problem = read(kGood);
  EXPECT_EQ(problem.map, folder / "maps/hall.yaml");
  EXPECT_EQ(problem.alignability, std::vector{folder / "hall_alignability.yaml"});
  EXPECT_EQ(problem.scene, folder / "hall.sdf");
  EXPECT_EQ(problem.sensor, folder / "../sensors/hdl32e.yaml");
  EXPECT_EQ(problem.range_max, 6.5);
  const PlanQuery& query = problem.query;
  EXPECT_EQ(query.robot.radius, 0.6);
  EXPECT_EQ(query.motion.space, MotionSpace::r2);
  EXPECT_EQ(query.motion.turn_cost, 0.3);
  EXPECT_EQ(query.start, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(query.goal, (Pose2{3, 4, -0.5}));
  EXPECT_EQ(query.goal_tolerance.position, 0.2);
  EXPECT_NEAR(query.goal_tolerance.heading, radians(90), 1e-15);
  EXPECT_EQ(query.weight, 7.0);
  EXPECT_EQ(query.risk.alpha_critical, 0.2);
  EXPECT_EQ(query.risk.alpha_safe, 0.5);
  EXPECT_EQ(query.risk.unknown, UnknownPolicy::neutral);
  EXPECT_EQ(query.planner.name, "prmstar");
  EXPECT_EQ(query.planner.time, 3.5);
  EXPECT_EQ(query.planner.seed, 9u);
  EXPECT_FALSE(query.planner.iterations.has_value());
}

TEST_F(ProblemFileTest, FillsInTheDefaultsOfTheTypes) {
  const ProblemFile problem = read("map: m.yaml\nalignability: a.yaml\nrobot: {radius: 1}\nstart: [0, 0, 0]\ngoal: [1, 1, 0]\n");
  EXPECT_EQ(problem.query.weight, PlanQuery{}.weight);
  EXPECT_EQ(problem.query.motion.space, MotionSpace::se2);
  EXPECT_EQ(problem.query.risk.unknown, UnknownPolicy::risky);
  EXPECT_TRUE(problem.query.planner.name.empty());
}

TEST_F(ProblemFileTest, ReadsLimits) {
  const std::string maps = "map: m.yaml\nalignability: a.yaml\nrobot: {radius: 1}\nstart: [0, 0, 0]\ngoal: [1, 1, 0]\n";
  const PlanQuery query =
      read(maps + "risk: {max_blind_distance: 0, recovery_distance: 2, min_alignability: 0.05, max_error: 0.2}\n").query;
  EXPECT_EQ(query.max_blind_distance, 0.0);
  EXPECT_EQ(query.recovery_distance, 2.0);
  EXPECT_EQ(query.risk.min_alpha, 0.05);
  EXPECT_EQ(query.max_error, 0.2);
  EXPECT_EQ(to_yaml(read(maps.substr(0, maps.find("robot")) + to_yaml(query)).query), to_yaml(query));
  EXPECT_THROW(read(maps + "risk: {max_blind_distance: -1}\n"), InputError);
  EXPECT_THROW(read(maps + "risk: {recovery_distance: 0}\n"), InputError);
  EXPECT_THROW(read(maps + "risk: {min_alignability: 1.1}\n"), InputError);
}

TEST_F(ProblemFileTest, NamesSeveralAlignabilityMapsAsScenarios) {
  const std::string rest = "robot: {radius: 1}\nstart: [0, 0, 0]\ngoal: [1, 1, 0]\n";
  const ProblemFile racks = read("map: m.yaml\nalignability: [full.yaml, sub/empty.yaml]\nscenarios: {quantile: 0.25}\n" + rest);
  EXPECT_EQ(racks.alignability, (std::vector{folder / "full.yaml", folder / "sub/empty.yaml"}));
  EXPECT_EQ(racks.scenario_quantile, 0.25);
  EXPECT_EQ(read("map: m.yaml\nalignability: [full.yaml, empty.yaml]\n" + rest).scenario_quantile, 0.0) << "the worst case";
  EXPECT_THROW(read("map: m.yaml\nalignability: []\n" + rest), InputError);
  EXPECT_THROW(read("map: m.yaml\nalignability: [a.yaml]\nscenarios: {quantile: 2}\n" + rest), InputError);
}

TEST_F(ProblemFileTest, TakesTheWorstOfItsScenarios) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 2, .height = 1};
  map.layers = {{"alpha", Grid<float>(map.geometry, std::vector{0.2f, 0.7f})}};
  write_alignability_map(map, folder / "full");
  map.layers = {{"alpha", Grid<float>(map.geometry, std::vector{0.5f, 0.1f})}};
  write_alignability_map(map, folder / "empty");
  write_file(folder / "m.pgm", "P5 2 1 255\n" + std::string(2, '\xfe'));
  write_file(folder / "m.yaml", "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string text =
      "map: m.yaml\nalignability: [full.yaml, empty.yaml]\nrobot: {radius: 0.1}\nstart: [0.5, 0.5, 0]\ngoal: [1.5, 0.5, 0]\n";
  EXPECT_EQ(load_problem(read(text)).alignability.alpha().values(), (std::vector{0.2f, 0.1f}));
  map.geometry.width = 1;
  map.layers = {{"alpha", Grid<float>(map.geometry, std::vector{0.5f})}};
  write_alignability_map(map, folder / "empty");
  EXPECT_THROW(load_problem(read(text)), InputError);
}

TEST_F(ProblemFileTest, IsWrittenOutAsItWasRead) {
  const ProblemFile first = read(kGood);
  const ProblemFile second = read("map: m.yaml\nalignability: a.yaml\n" + to_yaml(first.query));
  EXPECT_EQ(to_yaml(second.query), to_yaml(first.query));
  EXPECT_EQ(second.query.start, first.query.start);
  EXPECT_EQ(second.query.weight, first.query.weight);
}

TEST_F(ProblemFileTest, ReadsAFootprintAndWritesItOut) {
  std::string text = kGood;
  text.replace(text.find("radius: 0.6"), 11, "footprint: [[1, 0.5], [-0.25, 0.5], [-0.25, -0.5], [1, -0.5]]");
  text.replace(text.find("space: r2"), 9, "space: se2");
  const Robot robot = read(text).query.robot;
  ASSERT_EQ(robot.footprint.size(), 4u);
  EXPECT_EQ(robot.footprint[1], Eigen::Vector2d(-0.25, 0.5));
  EXPECT_EQ(inscribed_radius(robot), 0.25);
  EXPECT_EQ(circumscribed_radius(robot), std::hypot(1.0, 0.5));
  const ProblemFile again = read("map: m.yaml\nalignability: a.yaml\n" + to_yaml(read(text).query));
  EXPECT_EQ(again.query.robot.footprint, robot.footprint);
}

TEST_F(ProblemFileTest, ReadsACarsMotionAndWritesItOut) {
  const auto with_motion = [](const std::string& motion) {
    std::string text = kGood;
    const std::string was = "motion: {space: r2, turn_cost: 0.3}";
    text.replace(text.find(was), was.size(), "motion: {" + motion + "}");
    text.replace(text.find("prmstar"), 7, "rrtstar");
    return text;
  };
  const PlanQuery dubins = read(with_motion("space: dubins, turning_radius: 1.5")).query;
  EXPECT_EQ(dubins.motion.space, MotionSpace::dubins);
  EXPECT_EQ(dubins.motion.turning_radius, 1.5);
  const PlanQuery car = read(with_motion("space: reeds_shepp, turning_radius: 2, turn_cost: 0, reverse_penalty: 0.5")).query;
  EXPECT_EQ(car.motion.space, MotionSpace::reeds_shepp);
  EXPECT_EQ(car.motion.reverse_penalty, 0.5);
  for (const PlanQuery& query : {dubins, car}) {
    EXPECT_EQ(to_yaml(read("map: m.yaml\nalignability: a.yaml\n" + to_yaml(query)).query), to_yaml(query));
  }
  const auto expect_refusal = [&](const std::string& motion, const std::string& message) {
    const std::string thrown = test::thrown_message([&] { read(with_motion(motion)); });
    EXPECT_NE(thrown.find(message), std::string::npos) << thrown;
  };
  expect_refusal("space: dubins", "problem.yaml:4:9: missing key 'turning_radius'");
  expect_refusal("space: dubins, turning_radius: 0", "problem.yaml:4:41: 'turning_radius' must be greater than 0");
  expect_refusal("space: se2, turning_radius: 1", "problem.yaml:4:38: a turning radius belongs to the spaces dubins and reeds_shepp");
  expect_refusal("space: dubins, turning_radius: 1, reverse_penalty: 1", "problem.yaml:4:61: only in the space reeds_shepp");
  expect_refusal("space: reeds_shepp, turning_radius: 1, reverse_penalty: -1", "'reverse_penalty' must be from 0 to 1e+09");
  expect_refusal("space: car, turning_radius: 1", "dubins");
}

TEST_F(ProblemFileTest, RefusesWhatIsWrongAtTheLineAndColumnOfIt) {
  struct Fault {
    const char* from;
    const char* to;
    const char* message;
  };
  const Fault faults[] = {
      {"weight: 7", "wieght: 7", "problem.yaml:8:8: unknown key 'wieght' (did you mean 'weight'?)"},
      {"weight: 7", "weight: -1", "problem.yaml:8:16: 'weight' must be from 0 to 1e+09, not -1"},
      {"weight: 7", "weight: .nan", "problem.yaml:8:16: 'weight' must be from 0 to 1e+09, not .nan"},
      {"alpha_critical: 0.2", "alpha_critical: 0.6", "'alpha_critical' must be less than 'alpha_safe'"},
      {"unknown: neutral", "unknown: netural",
       "'unknown' is 'netural', which is none of: risky, neutral, blocked (did you mean 'neutral'?)"},
      {"space: r2", "space: r3", "'space' is 'r3', which is none of: r2, se2, dubins, reeds_shepp"},
      {"radius: 0.6", "radius: 0", "'radius' must be greater than 0"},
      {"radius: 0.6", "radius: wide", "'radius' must be a number"},
      {"radius: 0.6", "radius: 0.6, footprint: [[0, 0], [1, 0], [0, 1]]", "problem.yaml:3:17: give 'radius' or 'footprint', not both"},
      {"radius: 0.6", "footprint: [[0, 0], [1, 0]]", "problem.yaml:3:20: a footprint needs at least 3 corners"},
      {"radius: 0.6", "footprint: [[0, 0], [1, 1], [1, 0], [0, 1]]", "the footprint's edges must not cross or touch"},
      {"radius: 0.6", "footprint: [[0, 0], [1e30, 0], [0, 1]]", "corners must be within 1000 m of base_link"},
      {"radius: 0.6", "footprint: [[0, 0], [1e-310, 0], [0, 1e-310]]", "the footprint must be a polygon with an area"},
      {"radius: 0.6", "footprint: [[0, 0], [1, 0], [2, 0]]", "the footprint must"},
      {"radius: 0.6", "footprint: [[0, 0], [1, 0], [2]]", "problem.yaml:3:37: 'footprint' must be a list of points [x, y]"},
      {"radius: 0.6", "footprint: [[0, 0], [1, .nan], [2, 1]]", "'footprint' must be a finite number, not .nan"},
      {"radius: 0.6", "footprint: 3", "'footprint' must be a list of points [x, y]"},
      {"radius: 0.6", "footprnt: [[0, 0], [1, 0], [0, 1]]", "unknown key 'footprnt' (did you mean 'footprint'?)"},
      {"radius: 0.6", "footprint: [[0, 0], [1, 0], [0, 1]]", "problem.yaml:4:9: a footprint has a heading, and the space r2 has none"},
      {"start: [1, 2, 0.5]", "start: [1, 2]", "'start' must be a list of 3 numbers, not 2"},
      {"start: [1, 2, 0.5]", "strat: [1, 2, 0.5]", "unknown key 'strat' (did you mean 'start'?)"},
      {"goal: [3, 4, -0.5]\n", "", "missing key 'goal'"},
      {"goal: [3, 4, -0.5]", "goal: [3, .inf, -0.5]", "'goal' must be a finite number"},
      {"name: prmstar", "name: prmsta", "unknown planner 'prmsta'"},
      {"name: prmstar", "name: rrtconnect", "OMPL's planner 'rrtconnect' is not offered: it ignores the objective"},
      {"seed: 9", "seed: 0", "'seed' must be a whole number from 1"},
      {"seed: 9", "seed: 9, seed: 8", "key 'seed' is given twice"},
      {"time: 3.5", "time: 3.5, iterations: 100", "give 'iterations' or 'time', not both"},
      {"time: 3.5", "time: 0", "'time' must be greater than 0"},
      {"heading_deg: 90", "heading_deg: 0", "'heading_deg' must be greater than 0 and at most 180"},
  };
  for (const Fault& fault : faults) {
    std::string text = kGood;
    text.replace(text.find(fault.from), std::string(fault.from).size(), fault.to);
    const std::string message = test::thrown_message([&] { read(text); });
    EXPECT_NE(message.find(fault.message), std::string::npos) << fault.to << " gave: " << message;
  }
}

}  // namespace
}  // namespace alignability
