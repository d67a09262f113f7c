// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/small_site.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kOccupancy{"occupancy", "world.sdf",    "--z-min", "0.1", "--z-max",
                                          "2",         "--resolution", "0.1",     "-o",  "occupancy"};
const std::vector<std::string> kMap{"map",         "--scene",   "world.sdf", "--occupancy", "occupancy.yaml", "--sensor",
                                    "sensor.yaml", "--samples", "2",         "-o",          "alignability"};

class Cli : public testing::Test {
 protected:
  Cli() { test::write_small_site(folder); }

  test::Outcome run(const std::vector<std::string>& arguments) const { return test::run_program(arguments, folder / ""); }
  test::Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  void make_maps() const {
    ASSERT_EQ(run(kOccupancy).exit_code, 0);
    ASSERT_EQ(run(kMap).exit_code, 0);
  }

  test::TemporaryFolder folder;
};

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

TEST_F(Cli, GoesFromAWorldToTwoPaths) {
  test::Outcome outcome = run(kOccupancy);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("occupancy.yaml") && exists("occupancy.pgm"));
  outcome = run(kMap);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("alignability.yaml") && exists("alignability.tiff") && exists("alignability.png"));
  outcome = run({"plan", "problem.yaml", "-o", "route"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("route.json") && exists("route.csv") && exists("route.png"));
  outcome = run({"compare", "problem.yaml", "-o", "both"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("both.json") && exists("both.png") && exists("both_shortest.csv") && exists("both_risk_aware.csv"));
  EXPECT_THAT(outcome.out, HasSubstr("relative"));
}

TEST_F(Cli, ScansAndScores) {
  test::Outcome outcome = run({"scan", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--at", "1.5,1.5,0.3", "-o", "scan.pcd"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("15 x 360 beams of coarse"));
  outcome = run({"score", "scan.pcd", "--json", "--picture", "scan.png"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists("scan.png"));
  const json score = json::parse(outcome.out);
  EXPECT_EQ(score["file"], "scan.pcd");
  EXPECT_THAT(keys(score), testing::UnorderedElementsAre("file", "points", "alpha", "eigenvalues", "weakest_direction", "planes_found",
                                                         "planes_kept", "engine", "seconds"));
  EXPECT_GT(score["alpha"].get<double>(), 0.1);
  const json several = json::parse(run({"score", "scan.pcd", "scan.pcd", "--json"}).out);
  ASSERT_TRUE(several.is_array());
  EXPECT_EQ(several.size(), 2u);
}

TEST_F(Cli, PrintsTheJsonThatTheDesignPromises) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  const json map = json::parse(run(kMap, {"--json"}).out);
  EXPECT_THAT(keys(map), testing::UnorderedElementsAre("cells", "cells_evaluated", "scans", "alpha", "seconds", "files"));
  EXPECT_EQ(map["scans"].get<int>(), 2 * map["cells_evaluated"].get<int>());
  const json plan = json::parse(run({"plan", "problem.yaml", "--json"}).out);
  EXPECT_EQ(plan["status"], "solved");
  EXPECT_THAT(keys(plan), testing::UnorderedElementsAre("status", "planner", "seed", "weight", "options", "cost", "length", "risk_integral",
                                                        "blind_length", "longest_blind", "alpha_mean", "alpha_min", "seconds",
                                                        "first_solution_seconds", "path"));
  const json compare = json::parse(run({"compare", "problem.yaml", "--json"}).out);
  EXPECT_THAT(keys(compare), testing::UnorderedElementsAre("shortest", "risk_aware", "ratio"));
  EXPECT_THAT(keys(compare["ratio"]), testing::UnorderedElementsAre("length", "blind_length", "risk_integral"));
  EXPECT_EQ(compare["shortest"]["weight"], 0.0);
  EXPECT_EQ(compare["risk_aware"]["weight"], 5.0);
}

TEST_F(Cli, WritesNoFileUnlessAskedTo) {
  make_maps();
  const int before = folder.files();
  EXPECT_EQ(run({"plan", "problem.yaml"}).exit_code, 0);
  EXPECT_EQ(run({"compare", "problem.yaml"}).exit_code, 0);
  EXPECT_EQ(folder.files(), before);
}

TEST_F(Cli, DropsAnExtensionGivenToAName) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  EXPECT_EQ(run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "second.yaml"}).exit_code, 0);
  EXPECT_TRUE(exists("second.yaml") && exists("second.pgm"));
  EXPECT_FALSE(exists("second.yaml.yaml"));
}

TEST_F(Cli, FlagsOverrideTheProblemFile) {
  make_maps();
  const json plan = json::parse(
      run({"plan", "problem.yaml", "--weight", "2", "--seed", "5", "--planner", "prmstar", "--time", "0.5", "--goal", "6,5,1", "--json"})
          .out);
  EXPECT_EQ(plan["weight"], 2.0);
  EXPECT_EQ(plan["seed"], 5);
  EXPECT_EQ(plan["planner"], "prmstar");
  EXPECT_EQ(plan["options"]["goal"], json({6.0, 5.0, 1.0}));
  EXPECT_EQ(plan["options"]["planner"]["time"], 0.5);
}

TEST_F(Cli, SaysNoWithExitCodeOne) {
  make_maps();
  const test::Outcome outcome = run({"plan", "problem.yaml", "--start", "4,3,0", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan["status"], "start_in_collision");
  EXPECT_TRUE(plan["cost"].is_null());
  EXPECT_EQ(plan["path"], json::array());
  EXPECT_THAT(outcome.err, HasSubstr("collides at the start"));
}

TEST_F(Cli, RefusesAWrongCommandLineWithExitCodeTwo) {
  struct Fault {
    std::vector<std::string> arguments;
    const char* message;
  };
  const Fault faults[] = {
      {{}, "A subcommand is required"},
      {{"plam", "problem.yaml"}, "did you mean 'plan'?"},
      {{"plan", "problem.yaml", "--wieght", "3"}, "did you mean '--weight'?"},
      {{"plan"}, "problem is required"},
      {{"plan", "problem.yaml", "--weight", "-3"}, "--weight"},
      {{"plan", "problem.yaml", "--time", "1", "--iterations", "5"}, "--time excludes --iterations"},
      {{"occupancy", "world.sdf", "-o", "x"}, "--z-min is required"},
      {{"occupancy", "world.sdf", "--z-min", "2", "--z-max", "1", "-o", "x"}, "--z-min must be less than --z-max"},
      {{"map", "--scene", "world.sdf", "--samples", "0"}, "--samples"},
      {{"score", "a.pcd", "b.pcd", "--picture", "x.png"}, "--picture draws one scan"},
      {{"score", "missing.pcd"}, "missing.pcd: no such file"},
      {{"plan", "missing.yaml"}, "missing.yaml: no such file"},
  };
  for (const Fault& fault : faults) {
    const test::Outcome outcome = run(fault.arguments);
    EXPECT_EQ(outcome.exit_code, 2) << fault.message;
    EXPECT_THAT(outcome.err, HasSubstr(fault.message));
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(Cli, ShowsWhereInAFileAFaultIs) {
  folder.write("bad.yaml",
               "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {radius: 0.3}\nstart: [1.5, 3, 0]\ngoal: [6.5, 3, 0]\nrisk: "
               "{wieght: 5}\n");
  const test::Outcome outcome = run({"plan", "bad.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, StartsWith("bad.yaml:6:8: unknown key 'wieght' (did you mean 'weight'?)"));
}

TEST_F(Cli, EndsHelpWithTwoExamples) {
  for (const std::string command : {"occupancy", "scan", "score", "map", "plan", "compare"}) {
    const test::Outcome outcome = run({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    const std::size_t examples = outcome.out.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << command;
    const std::string tail = outcome.out.substr(examples);
    const std::string line = "\n  alignability " + command;
    const std::size_t first = tail.find(line);
    ASSERT_NE(first, std::string::npos) << command;
    EXPECT_NE(tail.find(line, first + 1), std::string::npos) << command;
  }
  EXPECT_EQ(run({"--version"}).exit_code, 0);
}

TEST_F(Cli, LeavesNothingBehindWhenInterrupted) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  const int before = folder.files();
  std::vector<std::string> endless = kMap;
  endless[8] = "100000";
  const test::Outcome outcome = test::run_program(endless, folder / "", 1.0);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_EQ(folder.files(), before);
}

TEST_F(Cli, GivesTheSameMapFilesEveryTime) {
  make_maps();
  EXPECT_EQ(run({"map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "2", "--threads",
                 "1", "-o", "again"})
                .exit_code,
            0);
  const auto bytes = [&](const std::string& name) {
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes("alignability.tiff"), bytes("again.tiff"));
}

}  // namespace
}  // namespace alignability
