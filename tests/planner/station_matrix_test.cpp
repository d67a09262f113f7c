// SPDX-License-Identifier: BSD-3-Clause
#include "planner/station_matrix.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

using testing::HasSubstr;

const std::vector<Station> kStations{{"left", {2.0, 8.5, 0.0}}, {"right", {18.0, 8.5, 1.0}}, {"below", {10.0, 1.5, -1.0}}};

TEST(StationMatrix, HasWhatAPlanOfEachPairFinds) {
  PlanProblem problem = test::two_corridors();
  problem.query.goal_tolerance = {.position = 1e-6, .heading = 1e-6};
  for (const MotionSpace space : {MotionSpace::r2, MotionSpace::se2}) {
    problem.query.motion.space = space;
    const auto plans = plan_between(kStations, problem.query, PlanningFields(problem), {});
    for (std::size_t from = 0; from < 3; ++from) {
      for (std::size_t to = 0; to < 3; ++to) {
        ASSERT_EQ(plans[from][to].status, PlanStatus::solved);
        problem.query.start = kStations[from].pose;
        problem.query.goal = kStations[to].pose;
        const PlanResult alone = plan(problem, {});
        EXPECT_NEAR(plans[from][to].cost, alone.cost, 1e-2 * alone.cost + 1e-9);
        EXPECT_NEAR(plans[from][to].cost, plans[to][from].cost, 1e-5) << "to a millionth of a metre";
        EXPECT_LT((plans[from][to].path.back().position() - kStations[to].pose.position()).norm(), 1e-5);
        EXPECT_EQ(plans[from][to].path.front().position(), kStations[from].pose.position());
      }
    }
  }
}

TEST(StationMatrix, PlansForAFootprintAsAPlanDoes) {
  PlanProblem problem = test::two_corridors();
  problem.query.robot.footprint = {{-0.9, -0.3}, {0.9, -0.3}, {0.9, 0.3}, {-0.9, 0.3}};
  problem.query.planner.time = 2.0;
  const std::vector<Station> stations{kStations[0], kStations[1]};
  const auto plans = plan_between(stations, problem.query, PlanningFields(problem), {});
  problem.query.start = stations[0].pose;
  problem.query.goal = stations[1].pose;
  problem.query.goal_tolerance = {.position = 1e-6, .heading = 1e-6};
  const PlanResult alone = plan(problem, {});
  ASSERT_EQ(plans[0][1].status, alone.status);
  EXPECT_NEAR(plans[0][1].cost, alone.cost, 1e-6 * alone.cost);
}

TEST(StationMatrix, TellsOfAStationInAWallAndOneOffTheMap) {
  const PlanProblem problem = test::two_corridors();
  const std::vector<Station> stations{{"free", {2.0, 8.5, 0.0}}, {"in the block", {10.0, 5.0, 0.0}}, {"off", {-4.0, 5.0, 0.0}}};
  const auto plans = plan_between(stations, problem.query, PlanningFields(problem), {});
  EXPECT_EQ(plans[0][1].status, PlanStatus::goal_in_collision);
  EXPECT_EQ(plans[1][0].status, PlanStatus::start_in_collision);
  EXPECT_EQ(plans[0][2].status, PlanStatus::goal_outside_map);
  EXPECT_EQ(plans[2][0].status, PlanStatus::start_outside_map);
  EXPECT_EQ(plans[0][0].status, PlanStatus::solved);
}

TEST(StationMatrix, PlansForCarsAsAPlanDoes) {
  PlanProblem problem = test::two_corridors();
  problem.query.motion = {.space = MotionSpace::dubins, .turn_cost = 0.2, .turning_radius = 0.8, .reverse_penalty = 1.0};
  const std::vector<Station> stations{kStations[0], kStations[2]};
  const auto plans = plan_between(stations, problem.query, PlanningFields(problem), {});
  for (std::size_t from = 0; from < 2; ++from) {
    const PlanResult& way = plans[from][1 - from];
    ASSERT_EQ(way.status, PlanStatus::solved);
    EXPECT_FALSE(way.curves.empty());
    EXPECT_LT((way.path.back().position() - stations[1 - from].pose.position()).norm(), 1e-5);
    EXPECT_EQ(plans[from][from].cost, 0.0);
  }
}

TEST(StationMatrix, KeepsLimits) {
  PlanProblem problem = test::two_corridors();
  problem.query.weight = 0.0;
  problem.query.max_blind_distance = 3.0;
  const auto plans = plan_between(kStations, problem.query, PlanningFields(problem), {});
  EXPECT_EQ(plans[0][1].status, PlanStatus::solved);
  EXPECT_LE(*plans[0][1].longest_unrecovered, 3.0 + 1e-9);
  EXPECT_GT(plans[0][1].figures.length, 20.0) << "not through the blind corridor, which is 16 m";
}

TEST(StationMatrix, StopsWhenAsked) {
  const PlanProblem problem = test::two_corridors();
  const PlanningFields fields(problem);
  std::stop_source stop;
  std::size_t done = 0;
  const auto stop_after_one = [&](Progress progress) {
    done = progress.done;
    stop.request_stop();
  };
  EXPECT_THROW(plan_between(kStations, problem.query, fields, {.progress = stop_after_one, .stop = stop.get_token()}), Interrupted);
  EXPECT_EQ(done, 1u);
}

class StationFile : public testing::Test {
 protected:
  std::string fault_of(const std::string& text) const {
    folder.write("stations.yaml", text);
    try {
      read_station_file(folder / "stations.yaml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder;
};

TEST_F(StationFile, KeepsNamesInTheirOrder) {
  EXPECT_EQ(fault_of("stations:\n  zebra dock: [1, 2, 0.5]\n  10: [3, 4, 0]\n"), "");
  const std::vector<Station> stations = read_station_file(folder / "stations.yaml");
  ASSERT_EQ(stations.size(), 2u);
  EXPECT_EQ(stations[0].name, "zebra dock");
  EXPECT_EQ(stations[1].name, "10");
  EXPECT_EQ(stations[0].pose, (Pose2{1.0, 2.0, 0.5}));
}

TEST_F(StationFile, SaysWhatIsWrong) {
  EXPECT_THAT(fault_of("stations: {a: [1, 2, 3]}\n"), HasSubstr("at least two stations"));
  EXPECT_THAT(fault_of("stations: {a: [1, 2], b: [1, 2, 3]}\n"), HasSubstr("stations.yaml:1:"));
  EXPECT_THAT(fault_of("stations: {a: [1, 2, x], b: [1, 2, 3]}\n"), HasSubstr("stations.yaml:1:"));
  EXPECT_THAT(fault_of("stations: {a: [1, 2, 3], a: [1, 2, 3]}\n"), HasSubstr("'a'"));
  EXPECT_THAT(fault_of("station: {a: [1, 2, 3], b: [1, 2, 3]}\n"), HasSubstr("did you mean 'stations'?"));
  EXPECT_THAT(fault_of("stations: [1, 2]\n"), HasSubstr("stations.yaml:1:"));
}

}  // namespace
}  // namespace alignability
