// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/file.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/map_server.hpp"
#include "tests/cli/json_keys.hpp"
#include "tests/cli/site_cli.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using test::kMap;
using test::kOccupancy;
using testing::HasSubstr;
using testing::StartsWith;

class Cli : public test::SiteCli {};

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

TEST_F(Cli, MapsACloudAsTheWorldThatItWasSampledFrom) {
  ASSERT_EQ(run({"sample", "world.sdf", "--spacing", "0.05", "-o", "cloud.pcd"}).exit_code, 0);
  const test::Outcome sliced = run({"occupancy", "cloud.pcd", "--z-min", "0.1", "--z-max", "2", "-o", "occupancy"});
  EXPECT_EQ(sliced.exit_code, 0) << sliced.err;
  EXPECT_THAT(sliced.err, HasSubstr(" points, on each a disc, of 0.0"));
  std::vector<std::string> map = kMap;
  map[2] = "cloud.pcd";
  const test::Outcome mapped = run(map);
  EXPECT_EQ(mapped.exit_code, 0) << mapped.err;
  const test::Outcome plan = run({"plan", "problem.yaml"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  const test::Outcome leveled = run({"occupancy", "cloud.pcd", "--z-min", "0.1", "--z-max", "2", "-o", "level", "--level"});
  EXPECT_THAT(leveled.err, HasSubstr("cloud.pcd: leveled by 0.0"));
  EXPECT_THAT(leveled.out, HasSubstr("level.yaml: "));
  const test::Outcome explained = run({"explain", "2,3", "--scene", "cloud.pcd", "--sensor", "sensor.yaml", "--json"});
  EXPECT_EQ(explained.exit_code, 0) << explained.err;
}

TEST_F(Cli, TakesUnitAndUpAxisOfMeshesAlone) {
  folder.write("hall.obj", "v 0 0 0\nv 800 0 0\nv 800 0 -600\nv 0 0 -600\nv 0 300 0\nv 800 300 0\nf 1 2 3 4\nf 1 5 6 2\n");
  const std::vector<std::string> slice{"occupancy", "hall.obj", "--z-min", "0.1", "--z-max", "2", "-o", "hall", "--up", "y"};
  EXPECT_THAT(run(slice, {"--unit", "0.01"}).out, HasSubstr("hall.yaml: 80 x 1 cells of 0.1 m"));
  EXPECT_EQ(run(slice, {"--unit", "0"}).exit_code, 2);
  EXPECT_EQ(run(slice, {"--up", "w"}).exit_code, 2);
  const test::Outcome world = run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "o", "--unit", "0.01"});
  EXPECT_EQ(world.exit_code, 2);
  EXPECT_THAT(world.err, HasSubstr("--unit and --up are for meshes and point clouds"));
  const test::Outcome tilted = run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "o", "--level"});
  EXPECT_THAT(tilted.err, HasSubstr("is no point cloud, and --level is for these"));
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
  EXPECT_THAT(test::keys(score), testing::UnorderedElementsAre("file", "points", "alpha", "eigenvalues", "weakest_direction",
                                                               "planes_found", "planes_kept", "engine", "seconds"));
  EXPECT_GT(score["alpha"].get<double>(), 0.1);
  const json several = json::parse(run({"score", "scan.pcd", "scan.pcd", "--json"}).out);
  ASSERT_TRUE(several.is_array());
  EXPECT_EQ(several.size(), 2u);
}

TEST_F(Cli, ReadsAScanInOtherWaysWhenAsked) {
  ASSERT_EQ(run({"scan", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--at", "1.5,1.5,0", "-o", "scan.pcd"}).exit_code, 0);
  const std::vector<std::string> score{"score", "scan.pcd", "--sensor", "sensor.yaml", "--readings", "information,robust"};
  EXPECT_THAT(run(score).out, testing::ContainsRegex("seconds +robust +information\n"));
  const json read = json::parse(run(score, {"--json"}).out);
  EXPECT_GT(read["robust"].get<double>(), 0.1);
  EXPECT_THAT(test::keys(read["information"]), testing::UnorderedElementsAre("least", "weakest_direction", "yaw", "matrix"));
  EXPECT_GT(read["information"]["least"].get<double>(), 1e4);
  EXPECT_FALSE(read.contains("voxel"));
  const json explained =
      json::parse(run({"explain", "1.5,1.5", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--readings", "robust", "--json"}).out);
  EXPECT_EQ(explained["robust"], read["robust"]);
}

TEST_F(Cli, KeepsEachReadingInALayerOfItsOwn) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  ASSERT_EQ(run(kMap, {"--readings", "centred,voxel,robust,information"}).exit_code, 0);
  EXPECT_THAT(bytes("alignability.yaml"),
              HasSubstr("[alpha, samples, iqr, weak_x, weak_y, weak_z, centred, voxel, robust, information, information_yaw, "
                        "information_x, information_y]"));
  EXPECT_THAT(bytes("alignability.yaml"), HasSubstr("range_stddev: 0.005"));
}

TEST_F(Cli, RebuildsAPartOfAMapToTheBytesOfTheWhole) {
  make_maps();
  const std::string whole = bytes("alignability.tiff");
  ASSERT_EQ(run(kMap, {"--cells", "0,0", "3,1"}).exit_code, 0);
  EXPECT_NE(bytes("alignability.tiff"), whole);
  std::vector<std::string> rest = kMap;
  rest.back() = "rest";
  ASSERT_EQ(run(rest, {"--polygon", "-1,-1", "9,-1", "9,7", "-1,7", "--update", "alignability.yaml"}).exit_code, 0);
  EXPECT_EQ(bytes("rest.tiff"), whole);
  EXPECT_THAT(bytes("rest.yaml"), HasSubstr("update_of: alignability.yaml"));
  ASSERT_EQ(run(rest, {"--cells", "0,0", "--update", "rest.yaml"}).exit_code, 0);
  EXPECT_EQ(bytes("rest.tiff"), whole);
}

TEST_F(Cli, RefusesToUpdateAMapThatWasMadeOtherwise) {
  make_maps();
  const test::Outcome outcome = run(kMap, {"--cells", "0,0", "--update", "alignability.yaml", "--range-max", "5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "alignability.yaml: was made with 'floor: 0', not 'range_max: 5'\n");
  EXPECT_FALSE(exists("alignability.cells.part"));
}

TEST_F(Cli, LeavesTheCellsOfAWholeBuildAloneWhenItBuildsAPart) {
  make_maps();
  folder.write("alignability.part", "of a build that was interrupted");
  EXPECT_EQ(run(kMap, {"--cells", "0,0"}).exit_code, 0);
  EXPECT_TRUE(exists("alignability.part"));
}

TEST_F(Cli, ExplainsTheAlphaThatScanAndScoreGive) {
  ASSERT_EQ(
      run({"scan", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--at", "1.5,1.5,0", "--seed", "7", "-o", "scan.pcd"}).exit_code, 0);
  const json score = json::parse(run({"score", "scan.pcd", "--sensor", "sensor.yaml", "--json"}).out);
  const test::Outcome outcome =
      run({"explain", "1.5,1.5", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--seed", "7", "--json", "-o", "why.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json why = json::parse(outcome.out);
  EXPECT_THAT(test::keys(why), testing::UnorderedElementsAre("at", "yaw", "alpha", "verdict", "why", "eigenvalues", "weakest_direction",
                                                             "noise", "planes", "map"));
  EXPECT_EQ(why["at"], json({1.5, 1.5}));
  EXPECT_EQ(why["alpha"], score["alpha"]);
  EXPECT_EQ(why["eigenvalues"], score["eigenvalues"]);
  EXPECT_TRUE(why["map"].is_null());
  double share = 0.0;
  double holds = 0.0;
  int segments = 0;
  for (const json& plane : why["planes"]) {
    EXPECT_THAT(test::keys(plane),
                testing::UnorderedElementsAre("kind", "normal", "segments", "points", "share", "distance", "extents", "holds"));
    share += plane["share"].get<double>();
    holds += plane["holds"].get<double>();
    segments += plane["segments"].get<int>();
  }
  EXPECT_NEAR(share, 1.0, 1e-9);
  EXPECT_NEAR(holds, 1.0, 1e-9);
  EXPECT_EQ(segments, score["planes_kept"].get<int>());
  EXPECT_TRUE(exists("why.png"));
  EXPECT_EQ(json::parse(std::ifstream(folder / "why.json")), why);
}

TEST_F(Cli, ExplainsByAProblemFileBesideTheMap) {
  make_maps();
  folder.write("site.yaml",
               "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {radius: 0.3}\nstart: [1.5, 3, 0]\ngoal: [6.5, 3, 0]\n"
               "scene: world.sdf\nsensor: sensor.yaml\nrisk: {alpha_critical: 0.98, alpha_safe: 0.99}\n");
  const test::Outcome outcome = run({"explain", "1.5", "1.5", "--problem", "site.yaml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith("Blind, alpha 0.")) << "by the file's thresholds";
  EXPECT_THAT(outcome.out, HasSubstr("the median of 2 scans"));
  const json why = json::parse(run({"explain", "1.5,1.5", "--problem", "site.yaml", "--json"}).out);
  EXPECT_EQ(why["map"]["samples"], 2.0);
  EXPECT_THAT(run({"explain", "1.5,1.5", "--problem", "site.yaml", "--range-max", "4"}).err,
              HasSubstr("alignability.yaml was made without --range-max"));
  const std::pair<const char*, const char*> faults[] = {{"-1.5,-2", "occupancy.yaml: the place -1.5, -2 lies off it"},
                                                        {"4,3", "occupancy.yaml: the place 4, 3 is occupied"}};
  for (const auto& [place, message] : faults) {
    const test::Outcome refused = run({"explain", place, "--problem", "site.yaml"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(message));
  }
}

TEST_F(Cli, PrintsTheJsonThatTheDesignPromises) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  const json map = json::parse(run(kMap, {"--json"}).out);
  EXPECT_THAT(test::keys(map), testing::UnorderedElementsAre("cells", "cells_evaluated", "scans", "alpha", "seconds", "files"));
  EXPECT_EQ(map["scans"].get<int>(), 2 * map["cells_evaluated"].get<int>());
  const json plan = json::parse(run({"plan", "problem.yaml", "--json"}).out);
  EXPECT_EQ(plan["status"], "solved");
  EXPECT_THAT(test::keys(plan), testing::UnorderedElementsAre("status", "planner", "seed", "weight", "options", "cost", "lower_bound",
                                                              "length", "risk_integral", "blind_length", "longest_blind", "alpha_mean",
                                                              "alpha_min", "seconds", "first_solution_seconds", "path"));
  const json compare = json::parse(run({"compare", "problem.yaml", "--json"}).out);
  EXPECT_THAT(test::keys(compare), testing::UnorderedElementsAre("shortest", "risk_aware", "ratio"));
  EXPECT_THAT(test::keys(compare["ratio"]), testing::UnorderedElementsAre("length", "blind_length", "risk_integral"));
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

TEST_F(Cli, ShowsWhereInAFileAFaultIs) {
  folder.write("bad.yaml",
               "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {radius: 0.3}\nstart: [1.5, 3, 0]\ngoal: [6.5, 3, 0]\nrisk: "
               "{wieght: 5}\n");
  const test::Outcome outcome = run({"plan", "bad.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, StartsWith("bad.yaml:6:8: unknown key 'wieght' (did you mean 'weight'?)"));
}

TEST_F(Cli, SaysInOneLineThatACloudHasNoFloor) {
  std::string wall = "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (int i = 0; i < 400; ++i) wall += "0 " + std::to_string(0.3 * (i % 20)) + ' ' + std::to_string(0.3 * (i / 20)) + '\n';
  folder.write("wall.ply", wall);
  const test::Outcome outcome = run({"occupancy", "wall.ply", "--z-min", "0.1", "--z-max", "2", "-o", "o", "--level"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "wall.ply: no plane among its points is near level, so there is no floor to level it by\n");
}

TEST_F(Cli, ExportsForOtherPrograms) {
  ASSERT_EQ(run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "occupancy"}).exit_code, 0);
  ASSERT_EQ(run(kMap).exit_code, 0);
  ASSERT_EQ(run({"plan", "problem.yaml", "-o", "way"}).exit_code, 0);
  const test::Outcome outcome = run({"export", "problem.yaml", "way.csv", "--weight", "5", "-o", "site", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json written = json::parse(outcome.out);
  for (const json& file : written["files"]) EXPECT_TRUE(exists(file)) << file;
  const OccupancyMap mask = read_occupancy_map(folder / "site_mask.yaml");
  EXPECT_EQ(mask.geometry().width, read_occupancy_map(folder / "occupancy.yaml").geometry().width);
  const std::string nav2 = read_file(folder / "site_nav2.yaml", 1 << 20);
  EXPECT_THAT(nav2, HasSubstr("yaml_filename: site_mask.yaml"));
  EXPECT_THAT(nav2, HasSubstr("cost_travel_multiplier: 5.020 "));
  EXPECT_EQ(read_alignability_map(folder / "site_map.yaml").alpha().geometry().width, 9);
}

TEST_F(Cli, ReportsMapsAndPathsOnAPage) {
  ASSERT_EQ(run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "occupancy"}).exit_code, 0);
  ASSERT_EQ(run(kMap).exit_code, 0);
  const test::Outcome compared = run({"compare", "problem.yaml", "-o", "way", "--html", "both ways.html"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const std::string both = read_file(folder / "both ways.html", 1 << 24);
  EXPECT_THAT(both, HasSubstr("<title>both ways</title>"));
  EXPECT_THAT(both, HasSubstr(R"("command":"alignability compare problem.yaml -o way --html 'both ways.html'")"));
  EXPECT_THAT(both, HasSubstr(R"({"name":"risk-aware")"));
  EXPECT_THAT(both, HasSubstr("alpha_critical: 0.1"));

  const test::Outcome reported = run({"report", "problem.yaml", "way_shortest.csv", "-o", "one.html"});
  ASSERT_EQ(reported.exit_code, 0) << reported.err;
  EXPECT_EQ(reported.out, "wrote one.html\n");
  EXPECT_THAT(read_file(folder / "one.html", 1 << 24), HasSubstr(R"({"name":"way_shortest")"));
  EXPECT_EQ(run({"report", "problem.yaml", "-o", "map.html"}).exit_code, 0);
  EXPECT_THAT(read_file(folder / "map.html", 1 << 24), HasSubstr(R"("paths":[])"));
  EXPECT_EQ(run({"report", "problem.yaml", "-o", "nowhere/map.html"}).exit_code, 2);
}

TEST_F(Cli, EndsHelpWithTwoExamples) {
  for (const std::string command : {"occupancy", "scan", "sample", "score", "explain", "map", "plan", "compare", "evaluate", "export",
                                    "report", "validate", "calibrate", "completion"}) {
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

TEST_F(Cli, KeepsWhatIsDoneAndNothingElseWhenInterrupted) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  const int before = folder.files();
  std::vector<std::string> endless = kMap;
  endless[8] = "100000";
  const test::Outcome outcome = test::run_program(endless, folder / "", test::Signal{.after = 1.0, .number = SIGINT});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted; alignability.part keeps what is done"));
  EXPECT_EQ(folder.files(), before + 1);
  const test::Outcome other = run(kMap);
  EXPECT_EQ(other.exit_code, 0) << "no cell was done: " << other.err;
}

TEST_F(Cli, GoesOnWhereItWasKilledAndEndsInTheSameBytes) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  std::vector<std::string> map = kMap;
  map[8] = "6";  // most of the time goes into cells
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run(map).exit_code, 0);
  const double lasts = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::string undisturbed = bytes("alignability.tiff") + bytes("alignability.yaml");
  std::mt19937_64 engine(1);
  int killed = 0;
  int resumed = 0;
  for (int round = 0; round < 200 && killed < 20; ++round) {
    const double after = std::uniform_real_distribution<double>(0.0, 0.9 * lasts)(engine);
    const test::Outcome outcome = test::run_program(map, folder / "", test::Signal{.after = after, .number = SIGKILL});
    killed += outcome.exit_code == 128 + SIGKILL ? 1 : 0;
    resumed += outcome.err.find("cells are there; going on from them") != std::string::npos ? 1 : 0;
    if (outcome.exit_code == 0) {
      EXPECT_EQ(bytes("alignability.tiff") + bytes("alignability.yaml"), undisturbed) << "in round " << round;
    }
  }
  EXPECT_EQ(killed, 20);
  EXPECT_GT(resumed, 0);
  const test::Outcome last = run(map);
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(bytes("alignability.tiff") + bytes("alignability.yaml"), undisturbed);
  EXPECT_FALSE(exists("alignability.part"));
}

TEST_F(Cli, RefusesToLoseTheCellsOfAnotherBuild) {
  ASSERT_EQ(run(kOccupancy).exit_code, 0);
  folder.write("alignability.part", "my own notes");
  EXPECT_THAT(run(kMap).err, StartsWith("alignability.part: is not a checkpoint of ours"));
  EXPECT_TRUE(exists("alignability.part"));
}

TEST_F(Cli, GivesTheSameMapFilesEveryTime) {
  make_maps();
  EXPECT_EQ(run({"map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "2", "--threads",
                 "1", "-o", "again"})
                .exit_code,
            0);
  EXPECT_EQ(bytes("alignability.tiff"), bytes("again.tiff"));
}

}  // namespace
}  // namespace alignability
