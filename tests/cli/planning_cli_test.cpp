// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "tests/cli/site_cli.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class PlanningCli : public test::SiteCli {};

TEST_F(PlanningCli, ComparesOverWeights) {
  make_maps();
  const test::Outcome outcome = run({"compare", "problem.yaml", "--weights", "1,2", "-o", "both"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("risk integral      detour"));
  EXPECT_TRUE(exists("both_curve.png") && exists("both.png"));
  const json compare = json::parse(run({"compare", "problem.yaml", "--weights", "1,2", "--json"}).out);
  ASSERT_EQ(compare["curve"].size(), 4u);  // 0 and the problem's 5 as well
  EXPECT_EQ(compare["curve"][0]["weight"], 0.0);
  EXPECT_EQ(compare["curve"][0]["length"], compare["shortest"]["length"]);
  EXPECT_EQ(compare["curve"][3]["cost"], compare["risk_aware"]["cost"]);
}

TEST_F(PlanningCli, DrawsWhatKindsOfPicturesAreAskedFor) {
  make_maps();
  ASSERT_EQ(run({"compare", "problem.yaml", "--weights", "1", "-o", "both", "--pictures", "svg,pdf"}).exit_code, 0);
  for (const std::string name : {"both", "both_curve"}) {
    EXPECT_TRUE(bytes(name + ".svg").starts_with("<?xml")) << name;
    EXPECT_TRUE(bytes(name + ".pdf").starts_with("%PDF-")) << name;
    EXPECT_FALSE(exists(name + ".png")) << name;
  }
  ASSERT_EQ(run({"plan", "--pictures", "svg", "problem.yaml", "-o", "route.svg"}).exit_code, 0);
  EXPECT_TRUE(exists("route.svg") && exists("route.json"));
  const json map = json::parse(run(test::kMap, {"--json", "--pictures", "png,pdf"}).out);
  EXPECT_EQ(map["files"], (json{"alignability.yaml", "alignability.tiff", "alignability.png", "alignability.pdf"}));
  EXPECT_TRUE(exists("alignability.pdf"));
}

TEST_F(PlanningCli, ComparesOverLimitsOfBlindMetres) {
  make_maps();
  const std::vector<std::string> command{"compare", "problem.yaml", "--blind-limits", "0,50,50"};
  const test::Outcome outcome = run(command, {"-o", "both"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("longest unrecovered      detour"));
  EXPECT_TRUE(exists("both_limits.png"));
  const json compare = json::parse(run(command, {"--json"}).out);
  ASSERT_EQ(compare["limited"].size(), 2u);  // the loosest first, none twice
  EXPECT_EQ(compare["limited"][0]["options"]["risk"]["max_blind_distance"], 50.0);
  EXPECT_EQ(compare["limited"][0]["length"], compare["shortest"]["length"]);
  EXPECT_EQ(compare["limited"][0]["weight"], 0.0);
  EXPECT_EQ(run({"compare", "problem.yaml", "--pairs", "4", "--blind-limits", "1"}).exit_code, 2);
}

TEST_F(PlanningCli, ComparesBetweenRandomPairs) {
  make_maps();
  const test::Outcome outcome = run({"compare", "problem.yaml", "--pairs", "4", "--seed", "3", "-o", "pairs"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("4 pairs, 4 of them solved for both"));
  EXPECT_TRUE(exists("pairs.png") && exists("pairs.csv") && exists("pairs.json"));
  const json pairs = json::parse(run({"compare", "problem.yaml", "--pairs", "4", "--seed", "3", "--json"}).out);
  EXPECT_EQ(pairs["solved"], 4);
  EXPECT_EQ(pairs["each"].size(), 4u);
  EXPECT_GE(pairs["length_ratio"]["max"], pairs["length_ratio"]["median"]);
  EXPECT_EQ(run({"compare", "problem.yaml", "--pairs", "4", "--weights", "1"}).exit_code, 2);
}

TEST_F(PlanningCli, PlansForAFootprint) {
  make_maps();
  folder.write(
      "truck.yaml",
      "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {footprint: [[0.6, 0.25], [-0.2, 0.25], [-0.2, -0.25], [0.6, -0.25]]}\n"
      "start: [1.5, 3, 1.5]\ngoal: [6.5, 3, -1.5]\nplanner: {iterations: 5000, seed: 1}\n");
  const json plan = json::parse(run({"plan", "truck.yaml", "--json", "-o", "truck"}).out);
  EXPECT_EQ(plan["status"], "solved");
  EXPECT_EQ(plan["options"]["robot"]["footprint"].size(), 4u);
  EXPECT_TRUE(exists("truck.png"));
}

TEST_F(PlanningCli, PlansBetweenStationsAndTellsOfThoseThatCannotBeReached) {
  make_maps();
  folder.write("stations.yaml", "stations: {dock: [1.5, 1.5, 0], door: [6.5, 4.5, 1.5], 'bay, left': [1.5, 4.5, 0]}\n");
  const test::Outcome outcome = run({"plan", "problem.yaml", "--stations", "stations.yaml", "-o", "ways"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("bay, left"));
  const json ways = json::parse(std::ifstream(folder / "ways.json"));
  EXPECT_EQ(ways["stations"], json({"dock", "door", "bay, left"}));
  EXPECT_EQ(ways["cost"][0][0], 0.0);
  EXPECT_NEAR(ways["cost"][0][2].get<double>(), ways["cost"][2][0].get<double>(), 1e-5);
  EXPECT_GT(ways["paths"][0][1].size(), 1u);
  EXPECT_THAT(read_file(folder / "ways.csv", 10'000), HasSubstr("\ndock,\"bay, left\",solved,"));
  EXPECT_TRUE(std::filesystem::exists(folder / "ways.png"));
  folder.write("stations.yaml", "stations: {dock: [1.5, 1.5, 0], lost: [100, 4.5, 1.5]}\n");
  const test::Outcome lost = run({"plan", "problem.yaml", "--stations", "stations.yaml", "--json"});
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_THAT(lost.err, HasSubstr("from dock to lost: goal_outside_map"));
  EXPECT_EQ(json::parse(lost.out)["cost"][0][1], json());
}

TEST_F(PlanningCli, PlansWithinALimitOfBlindMetresAndAFloorOfAlignability) {
  make_maps();
  const json blind = json::parse(run({"plan", "problem.yaml", "--max-blind-distance", "50", "--recovery-distance", "2", "--json"}).out);
  EXPECT_EQ(blind["options"]["risk"]["max_blind_distance"], 50.0);
  EXPECT_LE(blind["longest_unrecovered"], 50.0);
  const test::Outcome high = run({"plan", "problem.yaml", "--min-alignability", "1", "--json"});
  EXPECT_EQ(high.exit_code, 1);
  EXPECT_THAT(high.err, HasSubstr("no path was found that keeps the limit; one was found with --min-alignability 0."));
  EXPECT_LT(json::parse(high.out)["greatest_min_alignability"], 1.0);
}

}  // namespace
}  // namespace alignability
