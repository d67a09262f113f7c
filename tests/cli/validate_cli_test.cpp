// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "costmap/alignability_map.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_site.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

class ValidateCli : public testing::Test {
 protected:
  ValidateCli() {
    test::write_small_site(folder);
    folder.write("drive.yaml", "odometry: {scale_bias: 0.02, position_noise: 0.01}\nparticles: 30\n");
    folder.write("driving.yaml",
                 "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {radius: 0.3}\nstart: [1.5, 3, 0]\ngoal: [6.5, 3, 0]\n"
                 "planner: {time: 5, seed: 1}\nscene: world.sdf\nsensor: sensor.yaml\ndrive: drive.yaml\n");
    EXPECT_EQ(run({"occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "--resolution", "0.1", "-o", "occupancy"}).exit_code, 0);
    EXPECT_EQ(run({"map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "1",
                   "--readings", "robust", "-o", "alignability"})
                  .exit_code,
              0);
    folder.write("path.csv", "x,y\n1.5,1.5\n6.5,1.5\n6.5,4.5\n");
  }

  test::Outcome run(const Words& arguments) const { return test::run_program(arguments, folder / ""); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  json read_json(const std::string& name) const { return json::parse(std::ifstream(folder / name)); }

  test::TemporaryFolder folder;
};

TEST_F(ValidateCli, DrivesPathsAndTellsHowFarOffTheLocalizerWas) {
  const test::Outcome outcome = run({"validate", "path", "driving.yaml", "path.csv", "path.csv", "--runs", "2", "-o", "driven"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ndt_mcl_sum"));
  EXPECT_TRUE(exists("driven.csv") && exists("driven_ndt_mcl_sum.png"));
  const json driven = read_json("driven.json");
  EXPECT_EQ(driven["runs"], 2);
  EXPECT_EQ(driven["seeds"], json::parse("[1, 2]"));
  EXPECT_LT(driven["error"]["mean"], 0.3);
  ASSERT_EQ(driven["paths"].size(), 2u);
  EXPECT_NEAR(driven["paths"][0]["length"], 8.0, 1e-9);
  EXPECT_EQ(driven["paths"][0]["error"], driven["paths"][1]["error"]) << "the same errors on every path";
  EXPECT_TRUE(driven["readings"].contains("robust"));
}

TEST_F(ValidateCli, DrivesATourWithSeveralLocalizersAndDrawsTheErrors) {
  const Words tour{"validate",     "map",
                   "driving.yaml", "--waypoints",
                   "1.5,1.5",      "6.5,1.5",
                   "6.5,4.5",      "1.5,4.5",
                   "--laps",       "1",
                   "--runs",       "2",
                   "--localizer",  "ndt_mcl_product,scan_matching",
                   "-o",           "tour"};
  const test::Outcome outcome = run(tour);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("rank correlation"));
  EXPECT_THAT(outcome.out, HasSubstr("untested")) << "so small a room has no twenty cells of either kind";
  for (const std::string name : {"ndt_mcl_product", "scan_matching"}) {
    EXPECT_TRUE(exists("tour_" + name + "_error.png") && exists("tour_" + name + "_scatter.png")) << name;
  }
  const json first = read_json("tour.json");
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1]["localizer"], "scan_matching");
  EXPECT_LT(first[1]["error"]["p95"], 0.1);
  EXPECT_FALSE(first[0]["cells"].empty());
  EXPECT_EQ(run(tour).exit_code, 0);
  EXPECT_EQ(read_json("tour.json"), first) << "the same seeds give the same errors";
}

TEST_F(ValidateCli, HoldsAMapInWhichThingsStandElsewhere) {
  const test::Outcome outcome = run({"validate", "path", "driving.yaml", "path.csv", "--runs", "1", "--moved", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("0 of 0 loose objects moved")) << "the block of 2 x 1 x 3 m is not loose";
}

TEST_F(ValidateCli, ComparesHowFarOffTheLocalizerIsAlongBothPaths) {
  const test::Outcome outcome = run({"compare", "driving.yaml", "--drive", "2", "-o", "both"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ndt_mcl_sum, driven 2 times"));
  EXPECT_THAT(outcome.out, HasSubstr("runs lost"));
  const json drive = read_json("both.json")["drive"];
  ASSERT_EQ(drive.size(), 1u);
  EXPECT_EQ(drive[0]["runs"], 2);
  EXPECT_GT(drive[0]["shortest"]["error"]["mean"], 0.0);
  EXPECT_GT(drive[0]["risk_aware"]["intervals"]["p95"][1], 0.0);
}

TEST_F(ValidateCli, DrivesThePairsThatDifferMost) {
  const test::Outcome outcome = run({"compare", "driving.yaml", "--pairs", "2", "--drive", "1", "-o", "pairs"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the 2 pairs that differ most, driven 1 times"));
  EXPECT_EQ(read_json("pairs.json")["each"][0]["drive"][0]["runs"], 1);
}

// The room is rich all over: a map that says otherwise of one half gives the fit something to tell apart.
void write_half_poor_map(const std::filesystem::path& name) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 8, .height = 6};
  Grid<float> alpha(map.geometry, 0.6f);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 4; ++x) alpha[Cell{x, y}] = 0.02f;
  }
  map.layers = {{"alpha", alpha}};
  write_alignability_map(map, name);
}

TEST_F(ValidateCli, CalibratesAMapAndPlansWithinAnError) {
  write_half_poor_map(folder / "half");
  folder.write("round.csv", "x,y\n1.5,1.5\n6.5,1.5\n6.5,4.5\n1.5,4.5\n1.5,1.5\n");
  const Words calibrate{"calibrate", "driving.yaml", "round.csv", "--held-out", "path.csv", "--runs", "2", "-o", "calibrated"};
  EXPECT_THAT(run(calibrate).err, HasSubstr("needs paths with at least 4 m of alignability up to 0.2")) << "there is none";
  Words with_half = calibrate;
  with_half.insert(with_half.end(), {"--alignability", "half.yaml"});
  const test::Outcome outcome = run(with_half);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("held out"));
  folder.write("elsewhere.yaml", read_file(folder / "driving.yaml", 1000));
  Words elsewhere = with_half;
  elsewhere.insert(elsewhere.end() - 2, {"--held-out", "elsewhere.yaml", "round.csv", "--json"});
  const json other = json::parse(run(elsewhere).out);
  ASSERT_EQ(other["paths"].size(), 3u);
  EXPECT_EQ(other["paths"][2]["problem"], "elsewhere.yaml");
  EXPECT_TRUE(other["paths"][2]["held_out"]);
  folder.write("elsewhere.yaml", read_file(folder / "driving.yaml", 1000) + "\nrange_max: 3\n");
  EXPECT_THAT(run(elsewhere).err,
              HasSubstr("elsewhere.yaml: an error model is for one way of driving: fitted for range in full, used for 3 m here"));
  const Words plan{"plan", "driving.yaml", "--alignability", "calibrated.yaml", "--json"};
  const auto planned = [&](const std::string& max_error) {
    Words words = plan;
    words.insert(words.end(), {"--max-error", max_error});
    return run(words);
  };
  const test::Outcome loose = planned("5");
  EXPECT_EQ(loose.exit_code, 0) << loose.err;
  EXPECT_EQ(loose.err, "");
  const json solved = json::parse(loose.out);
  EXPECT_GT(solved["predicted_error"], 0.0);
  const test::Outcome strict = planned("0.00001");
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.err, HasSubstr("no path was found that keeps the limit; one was found with --max-error"));
  EXPECT_EQ(json::parse(strict.out)["status"], "infeasible");
  EXPECT_EQ(solved["options"]["risk"]["max_error"], 5.0);
  folder.write("drive.yaml", "odometry: {scale_bias: 0.01}\n");
  EXPECT_THAT(planned("5").err, HasSubstr("the error model was fitted for an odometry bias of 0.02, used for 0.01"));
  EXPECT_THAT(run({"plan", "driving.yaml", "--max-error", "1"}).err, HasSubstr("needs an alignability map with an error model"));
}

TEST_F(ValidateCli, SaysWhatIsMissingOrWrong) {
  const auto fault = [&](const Words& arguments) {
    const test::Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    return outcome.err;
  };
  EXPECT_THAT(fault({"validate"}), HasSubstr("--help"));
  EXPECT_THAT(fault({"validate", "mop", "driving.yaml"}), HasSubstr("unknown command 'mop' (did you mean 'map'?)"));
  EXPECT_THAT(fault({"validate", "path", "problem.yaml", "path.csv"}), HasSubstr("problem.yaml: driving needs the key 'drive'"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "missing.csv"}), StartsWith("missing.csv: no such file"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "path.csv", "--runs", "0"}), StartsWith("alignability: --runs"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "path.csv", "--run", "1"}), HasSubstr("did you mean '--runs'?"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "path.csv", "--moved", "2"}), StartsWith("alignability: --moved"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "path.csv", "--noise", "nan"}), StartsWith("alignability: --noise: must be"));
  EXPECT_THAT(fault({"validate", "path", "driving.yaml", "path.csv", "--localizer", "ndt"}), HasSubstr("no localizer 'ndt'"));
  EXPECT_THAT(fault({"compare", "driving.yaml", "--localizer", "ndt_mcl_sum"}), HasSubstr("--drive"));
  EXPECT_THAT(fault({"calibrate", "driving.yaml", "path.csv", "--localizer", "ndt_mcl_sum,scan_matching", "-o", "x"}),
              HasSubstr("needs paths"));
  EXPECT_THAT(fault({"validate", "map", "driving.yaml", "--waypoints", "1,1,2"}), StartsWith("alignability: --waypoints: takes pairs"));
  EXPECT_THAT(fault({"validate", "map", "driving.yaml", "--waypoints", "1.5,1.5,4,3"}),
              HasSubstr("no way from 1.5,1.5 to 4,3: goal_in_collision"));
}

}  // namespace
}  // namespace alignability
