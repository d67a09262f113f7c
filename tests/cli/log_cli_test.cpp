// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "costmap/alignability_map.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_site.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

// A drive through the room, a scan each half metre, and its poses. What the robot sees is what it would by simulation.
class LogCli : public testing::Test {
 protected:
  LogCli() {
    test::write_small_site(folder);
    std::filesystem::create_directory(folder / "scans");
  }

  test::Outcome run(const std::vector<std::string>& arguments) const { return test::run_program(arguments, folder / ""); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  std::string bytes(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }
  void record(int scans) const {
    std::string poses = "# stamp x y z qx qy qz qw\n";
    for (int i = 0; i < scans; ++i) {
      const std::string x = std::to_string(1.25 + 0.5 * i);
      ASSERT_EQ(run({"scan", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--at", x + ",1.25,0", "--seed", std::to_string(i + 2),
                     "-o", "scans/" + std::to_string(100 + i) + ".pcd"})
                    .exit_code,
                0);
      poses += std::to_string(100 + i) + ".01 " + x + " 1.25 0 0 0 0 1\n";
    }
    folder.write("poses.txt", poses);
  }
  // Of so many cells, with one α all over.
  AlignabilityMap even_map(float alpha, int side = 4) const {
    AlignabilityMap map;
    map.geometry = {.resolution = 1.0, .origin = {0.0, 0.0}, .width = side, .height = side};
    for (const auto& [name, value] : {std::pair{"alpha", alpha}, {"samples", 10.0f}, {"iqr", 0.02f}}) {
      map.layers.push_back({name, Grid<float>(map.geometry, value)});
    }
    return map;
  }

  const std::vector<std::string> log_{"map",      "--log",       "scans/",     "--trajectory", "poses.txt",
                                      "--sensor", "sensor.yaml", "--poses-of", "base_link"};
  std::vector<std::string> log(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = log_;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  test::TemporaryFolder folder;
};

TEST_F(LogCli, MapsALogAndMergesItWithASimulatedMap) {
  record(4);
  ASSERT_EQ(run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "occupancy"}).exit_code, 0);
  ASSERT_EQ(
      run({"map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "4", "-o", "simulated"})
          .exit_code,
      0);
  test::Outcome outcome = run(log({"--occupancy", "occupancy.yaml", "--json", "-o", "logged"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["scans"], 4);
  EXPECT_EQ(summary["cells_evaluated"], 2);
  EXPECT_TRUE(exists("logged.yaml") && exists("logged.tiff") && exists("logged.png") && exists("logged.csv"));
  EXPECT_THAT(bytes("logged.yaml"),
              HasSubstr("log: scans\n  trajectory: poses.txt\n  poses_of: base_link\n  paired_by: stamp\n  scans: 4"));
  EXPECT_THAT(bytes("logged.csv"), HasSubstr("\n101.pcd,101.000000,1.7450,1.2500,0.0000,"));

  outcome = run({"compare-maps", "simulated.yaml", "logged.yaml", "--occupancy", "occupancy.yaml", "--json", "-o", "change"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["cells"], 2);
  EXPECT_TRUE(exists("change.png") && exists("change.json"));

  outcome = run({"map", "--merge", "simulated.yaml", "logged.yaml", "--occupancy", "occupancy.yaml", "--json", "-o", "merged"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["cells_taken"], 2);
  EXPECT_THAT(bytes("merged.yaml"), HasSubstr("merged: [simulated.yaml, logged.yaml]"));
}

TEST_F(LogCli, MapsALogWithoutAnOccupancyMap) {
  record(2);
  folder.write("scans/900.pcd", bytes("scans/100.pcd"));
  const test::Outcome outcome = run(log({"-o", "logged"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "warning: 1 of 3 scans have no pose and are left out, first 900.pcd\n");
  const AlignabilityMap map = read_alignability_map(folder / "logged.yaml");
  EXPECT_EQ(map.geometry.origin, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(map.geometry.width, 3);
}

TEST_F(LogCli, JoinsALogIntoACloud) {
  record(2);
  const test::Outcome outcome = run({"join", "scans", "--trajectory", "poses.txt", "--poses-of", "base_link", "--sensor", "sensor.yaml",
                                     "--thin", "0.2", "--json", "-o", "cloud.pcd"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["scans"], 2);
  EXPECT_GT(summary["points"], 500);
  EXPECT_LT(summary["points"], 10800);
  EXPECT_THAT(bytes("cloud.pcd"), HasSubstr("POINTS " + summary["points"].dump() + "\n"));
}

TEST_F(LogCli, WarnsAndSaysNoWhereTheSecondMapReadsLower) {
  write_alignability_map(even_map(0.5f), folder / "before");
  AlignabilityMap after = even_map(0.5f);
  after.layers.front().values[Cell{2, 1}] = 0.05f;
  write_alignability_map(after, folder / "after");
  test::Outcome outcome = run({"compare-maps", "before.yaml", "after.yaml", "--worst", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err,
              StartsWith("warning: after.yaml reads lower in 1 of 16 cells, by more than chance explains: the site has changed"));
  EXPECT_THAT(outcome.out, HasSubstr("alpha critical, 0.1: 1 cells fell below, 0 rose\n"));
  EXPECT_THAT(outcome.out, HasSubstr("     2.50      1.50     0.500     0.050    -0.450  lower\n"));
  const json summary = json::parse(run({"compare-maps", "before.yaml", "after.yaml", "--json"}).out);
  EXPECT_EQ(summary["lower"], 1);
  EXPECT_EQ(summary["lower_cells"][0]["x"], 2.5);
  outcome = run({"compare-maps", "after.yaml", "before.yaml"});
  EXPECT_EQ(outcome.exit_code, 0) << "higher is no loss";
  EXPECT_EQ(outcome.err, "");
}

TEST_F(LogCli, SaysWhatIsWrong) {
  record(1);
  write_alignability_map(even_map(0.5f), folder / "even");
  AlignabilityMap aside = even_map(0.5f);
  aside.geometry.origin = {0.5, 0.0};
  for (AlignabilityMap::Layer& layer : aside.layers) layer.values = Grid<float>(aside.geometry, layer.values.values());
  write_alignability_map(aside, folder / "aside");
  folder.write("bad.txt", "100 0 0 0 0 0 0 1\n101 0 0 nan 0 0 0 1\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"map", "-o", "a"}, "alignability: One of --scene, --log, --merge and --sites is required"},
      {{"map", "--log", "scans", "-o", "a"}, "alignability: --log requires --trajectory"},
      {{"map", "--scene", "world.sdf", "--sensor", "sensor.yaml", "-o", "a"}, "alignability: --scene requires --occupancy"},
      {{"map", "--log", "scans", "--trajectory", "poses.txt", "--samples", "3", "-o", "a"}, "alignability: --samples excludes --log"},
      {{"map", "--log", "scans", "--trajectory", "poses.txt", "--scene", "world.sdf", "-o", "a"}, "alignability: --scene excludes --log"},
      {{"map", "--scene", "world.sdf", "--pair-by", "order", "-o", "a"}, "alignability: --pair-by excludes --scene"},
      {{"map", "--merge", "even.yaml", "even.yaml", "--stride", "2", "-o", "a"}, "alignability: --stride excludes --merge"},
      {{"map", "--log", "scans", "--trajectory", "poses.txt", "--poses-of", "base_link", "-o", "a"},
       "alignability: --poses-of base_link takes --sensor: its mount says where the lidar is"},
      {{"map", "--log", "scans", "--trajectory", "bad.txt", "-o", "a"},
       "bad.txt:2:9: a coordinate must be from -1e+07 to 1e+07, not 'nan'"},
      {{"map", "--log", "scans", "--trajectory", "poses.txt", "--max-gap", "0.001", "-o", "a"},
       "poses.txt: has no pose within 0.001 s of any scan in scans: by their names these are from 100 (100.pcd) to 100, poses from 100.01 "
       "to "
       "100.01"},
      {{"map", "--log", "none", "--trajectory", "poses.txt", "-o", "a"}, "none: cannot be read as a folder of scans"},
      {{"map", "--merge", "even.yaml", "aside.yaml", "-o", "a"},
       "even.yaml: cannot be merged with the other map: the maps do not have the same cells"},
      {{"compare-maps", "even.yaml", "aside.yaml"}, "aside.yaml: cannot be compared with even.yaml: the maps do not have the same cells"},
      {{"join", "scans", "-o", "cloud.pcd"}, "alignability: --trajectory is required"},
      {{"join", "scans", "--trajectory", "poses.txt", "-o", "cloud.ply"}, "alignability: --output: the cloud is written as PCD"},
      {{"join", "scans", "--trajectory", "poses.txt", "--range-max", "0.3", "-o", "cloud.pcd"},
       "alignability: the scans have no points between"},
  };
  for (const auto& [arguments, message] : table) {
    const test::Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.err, StartsWith(message));
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_FALSE(exists("a.yaml") || exists("cloud.pcd"));
}

TEST_F(LogCli, HoldsALogAgainstTheSiteThatItWasTakenIn) {
  record(4);
  const std::vector<std::string> held{"validate",  "log",      "scans",       "--trajectory", "poses.txt", "--poses-of",
                                      "base_link", "--sensor", "sensor.yaml", "--scene",      "world.sdf"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), held.begin(), held.end());
    return run(more);
  };
  const test::Outcome outcome = with({"--json", "-o", "held"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  EXPECT_EQ(told["scans"], 4);
  EXPECT_LT(told["difference"]["max"], 0.05) << "but for their noise the scans are the same";
  EXPECT_TRUE(exists("held.png"));
  EXPECT_THAT(bytes("held.csv"), StartsWith("scan,x,y,z,recorded_alpha,simulated_alpha,"));
  EXPECT_THAT(with({}).out, StartsWith("4 scans: simulated alpha is off by 0.0"));
  EXPECT_EQ(with({"--level"}).exit_code, 2);
}

TEST_F(LogCli, MapsAndJoinsACarmenLogByItsOwnPoses) {
  std::string ranges;
  for (int beam = 0; beam <= 180; ++beam) {  // of a wall 2 m ahead, and nothing at the sides
    const double along = std::cos((beam - 90) * std::acos(-1.0) / 180.0);
    ranges += (along > 0.51 ? std::to_string(2.0 / along) : "81.91") + ' ';
  }
  folder.write("site.log", "PARAM robot_length 1\nFLASER 181 " + ranges + "1.5 1.5 0 0 0 0 7 host 7\nFLASER 181 " + ranges +
                               "1.5 1.5 1.5708 0 0 0 8 host 8\n");
  const test::Outcome mapped = run({"map", "--log", "site.log", "-o", "carmen", "--json"});
  ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  EXPECT_EQ(json::parse(mapped.out)["scans"], 2);
  EXPECT_EQ(json::parse(mapped.out)["cells_evaluated"], 1);
  EXPECT_LT(json::parse(mapped.out)["alpha"]["max"], 0.01) << "a lone wall holds one way alone";
  EXPECT_THAT(bytes("carmen.csv"), HasSubstr("site.log:3,8.000000,1.5000,1.5000,"));
  const test::Outcome joined = run({"join", "site.log", "-o", "cloud.pcd", "--json"});
  ASSERT_EQ(joined.exit_code, 0) << joined.err;
  EXPECT_EQ(json::parse(joined.out)["points"], 2 * 119);
  folder.write("poses.txt", "1 0 0 0 0 0 0 1\n");
  const test::Outcome twice = run({"map", "--log", "site.log", "--trajectory", "poses.txt", "-o", "carmen"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("--trajectory excludes --log"));
  folder.write("site.log", "FLASER 181 1 2 3\n");
  EXPECT_THAT(run({"map", "--log", "site.log", "-o", "carmen"}).err,
              HasSubstr("site.log:1:8: the count of beams is 181, but only 3 values follow"));
  EXPECT_THAT(run({"join", "scans", "-o", "cloud.pcd"}).err, HasSubstr("--trajectory is required for a folder of scans"));
}

}  // namespace
}  // namespace alignability
