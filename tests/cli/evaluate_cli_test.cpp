// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/json_keys.hpp"
#include "tests/cli/program.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::filesystem::path kSite = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps/warehouse";
const std::string kProblem = kSite / "problem.yaml";
const std::string kLanes = kSite / "lanes.geojson";

class EvaluateCommand : public testing::Test {
 protected:
  test::Outcome evaluate(const std::string& route, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"evaluate", route, "--problem", kProblem};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_program(arguments, folder / "");
  }
  std::string text(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TemporaryFolder folder;
};

TEST_F(EvaluateCommand, GivesAPlansFileTheFiguresOfThePlan) {
  ASSERT_EQ(test::run_program({"plan", kProblem, "--iterations", "2000", "-o", "plan"}, folder / "").exit_code, 0);
  const json plan = json::parse(text("plan.json"));
  const test::Outcome outcome = evaluate("plan.csv", {"--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json scored = json::parse(outcome.out);
  EXPECT_EQ(scored["status"], "solved");
  EXPECT_TRUE(scored["obstruction"].is_null());
  for (const char* figure : {"cost", "length", "risk_integral", "blind_length", "longest_blind", "alpha_mean", "alpha_min", "weight"}) {
    EXPECT_NEAR(scored[figure].get<double>(), plan[figure].get<double>(), 1e-9) << figure;
  }
  std::vector<std::string> expected = test::keys(plan);
  expected.push_back("obstruction");
  EXPECT_THAT(test::keys(scored), testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(scored["options"]["start"], plan["path"].front());
  EXPECT_EQ(scored["path"].front(), plan["path"].front());
  EXPECT_EQ(scored["path"].back(), plan["path"].back());
}

TEST_F(EvaluateCommand, PrintsTheEdgesOfAGraphTheWorstFirst) {
  const test::Outcome outcome = evaluate(kLanes);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::MatchesRegex(
                               "edge +length +blind +longest +risk +alpha +least\n102: 2 - 3 +42\\.00 m .*\nall 9 edges +153\\.32 m .*"));
}

TEST_F(EvaluateCommand, WritesTheEdgesOfAGraphAndAPicture) {
  ASSERT_EQ(evaluate(kLanes, {"-o", "lanes.json"}).exit_code, 0);
  EXPECT_TRUE(text("lanes.png").starts_with("\x89PNG"));
  EXPECT_TRUE(
      text("lanes.csv")
          .starts_with(
              "id,from,to,status,x,y,cost,length,risk_integral,blind_length,longest_blind,alpha_mean,alpha_min\n102,2,3,solved,,,"));
  const json lanes = json::parse(text("lanes.json"));
  ASSERT_EQ(lanes["edges"].size(), 9u);
  const json& worst = lanes["edges"][0];
  EXPECT_THAT(test::keys(worst),
              testing::UnorderedElementsAre("id", "from", "to", "status", "obstruction", "cost", "length", "risk_integral", "blind_length",
                                            "longest_blind", "alpha_mean", "alpha_min", "path"));
  EXPECT_EQ(worst["id"], "102");
  EXPECT_EQ(worst["path"], json({{9.0, 22.5, 0.0}, {51.0, 22.5, 0.0}}));
  double length = 0.0;
  for (const json& edge : lanes["edges"]) length += edge["length"].get<double>();
  EXPECT_NEAR(lanes["length"].get<double>(), length, 1e-9);
  EXPECT_EQ(lanes["path"], json::array());
}

TEST_F(EvaluateCommand, ScoresThePathAlongNodes) {
  const json path = json::parse(evaluate(kLanes, {"--nodes", "1,2,3,4", "--json"}).out);
  EXPECT_EQ(path["path"].size(), 6u);
  EXPECT_FALSE(path.contains("edges"));
  const json around = json::parse(evaluate(kLanes, {"--nodes", "1,5,6,7,8,4", "--json"}).out);
  EXPECT_GT(path["blind_length"].get<double>(), 35.0);
  EXPECT_EQ(around["blind_length"], 0.0);
}

TEST_F(EvaluateCommand, ScoresWhatCollidesAllTheSameAndSaysNo) {
  folder.write("through.csv", "5,20\n30,20\n55,20\n");
  const test::Outcome outcome = evaluate("through.csv", {"-o", "through"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "through.csv: there is no yaw: the robot looks where it goes\nthrough.csv: the robot collides at x 9.30, y 20.00\n");
  EXPECT_THAT(outcome.out, HasSubstr("length                   50.00 m"));
  const json scored = json::parse(text("through.json"));
  EXPECT_EQ(scored["status"], "in_collision");
  EXPECT_NEAR(scored["obstruction"][0].get<double>(), 9.3, 1e-6);
  EXPECT_NEAR(scored["length"].get<double>(), 50.0, 1e-12);
  EXPECT_TRUE(text("through.csv").starts_with("x,y,yaw,s,alpha,risk\n5,20,0,0,"));
}

TEST_F(EvaluateCommand, NamesTheEdgeThatIsObstructed) {
  folder.write("graph.json", R"({"type": "FeatureCollection", "features": [
    {"properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [5, 20]}},
    {"properties": {"id": 2}, "geometry": {"type": "Point", "coordinates": [5, 21]}},
    {"properties": {"id": 3}, "geometry": {"type": "Point", "coordinates": [-5, 20]}},
    {"properties": {"id": 4, "startid": 1, "endid": 2}, "geometry": {"type": "LineString"}},
    {"properties": {"id": 5, "startid": 3, "endid": 1}, "geometry": {"type": "LineString"}}]})");
  const test::Outcome outcome = evaluate("graph.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "graph.json: 1 of 2 edges obstructed; edge 5: the robot leaves the map at x -5.00, y 20.00\n");
  EXPECT_THAT(outcome.out, HasSubstr("  the robot leaves the map at x -5.00, y 20.00\n4: 1 - 2 "));
}

TEST_F(EvaluateCommand, RefusesWhatItCannotScoreWithExitCodeTwo) {
  folder.write("path.csv", "5,20\n6,20\n");
  folder.write("bad.csv", "5,20\n6,two\n");
  struct Fault {
    std::string route;
    std::vector<std::string> more;
    std::string message;
  };
  const Fault faults[] = {
      {"bad.csv", {}, "bad.csv:2:3: 'y' must be a number, not 'two'\n"},
      {"missing.csv", {}, "missing.csv: no such file\n"},
      {kProblem, {}, kProblem + ": is no route: a path is .csv or .txt, a graph .geojson, .json or .lif\n"},
      {kLanes, {"--nodes", "1,3"}, "alignability: no edge leads from node '1' to node '3'\n"},
      {kLanes, {"--nodes", "1"}, "alignability: a path along nodes needs at least two of them\n"},
      {kLanes, {"--vehicle", "truck"}, kLanes + ": a vehicle and a map are chosen from LIF files only\n"},
      {"path.csv",
       {"--nodes", "1,2"},
       "path.csv: there is no yaw: the robot looks where it goes\nalignability: --nodes chooses from a graph, and path.csv is a path\n"},
  };
  for (const Fault& fault : faults) {
    const test::Outcome outcome = evaluate(fault.route, fault.more);
    EXPECT_EQ(outcome.exit_code, 2) << fault.message;
    EXPECT_EQ(outcome.err, fault.message);
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(test::run_program({"evaluate", "path.csv"}, folder / "").err, testing::StartsWith("alignability: --problem is required"));
}

}  // namespace
}  // namespace alignability
