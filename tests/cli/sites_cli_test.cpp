// SPDX-License-Identifier: BSD-3-Clause
// Many sites in one job.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/json_keys.hpp"
#include "tests/cli/site_cli.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> kSites{"map", "--sites", "sites.yaml"};

class SitesCli : public test::SiteCli {
 protected:
  void SetUp() override { ASSERT_EQ(run(test::kOccupancy).exit_code, 0); }

  void write_sites(const std::string& entries) const {
    folder.write("sites.yaml", "sensor: sensor.yaml\noccupancy: occupancy.yaml\nsamples: 1\nresolution: 2\nsites:\n" + entries);
  }
  std::vector<std::string> statuses() const {
    std::vector<std::string> found;
    for (const json& site : json::parse(run(kSites, {"--json"}).out)) found.push_back(site["status"]);
    return found;
  }
};

constexpr const char* kTwoOfThree =
    "  - {name: hall, scene: world.sdf}\n  - {name: the lost one, scene: missing.sdf}\n  - {name: yard, scene: world.sdf, seed: 2}\n";

TEST_F(SitesCli, BuildsAllThatCanBeBuiltAndSumsUp) {
  write_sites(kTwoOfThree);
  const test::Outcome first = run(kSites);
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_THAT(first.err, HasSubstr("1 of 3, hall: built\n2 of 3, the lost one: failed: "));
  const test::Outcome outcome = run(kSites);
  EXPECT_EQ(outcome.exit_code, 1);
  std::string masked = outcome.out;
  // The values are those of the machine's arithmetic, to three digits.
  for (std::size_t at = masked.find("0."); at != std::string::npos; at = masked.find("0.", at + 1)) masked.replace(at, 5, "0.###");
  EXPECT_EQ(masked,
            "site              cells  alpha, median    blind           time\n"
            "hall                 12          0.###    0.###           kept\n"
            "the lost one     failed: missing.sdf: no such file\n"
            "yard                 12          0.###    0.###           kept\n"
            "0 built, 2 kept, 1 failed\n");
}

TEST_F(SitesCli, TellsAProgramWhatItTellsOfOneMapAndWhatCameOfEachSite) {
  write_sites(kTwoOfThree);
  const json sites = json::parse(run(kSites, {"--json", "--threads", "1"}).out);
  ASSERT_EQ(sites.size(), 3u);
  EXPECT_THAT(test::keys(sites[0]), testing::UnorderedElementsAre("name", "status", "error", "cells", "cells_evaluated", "scans", "alpha",
                                                                  "seconds", "files", "blind"));
  EXPECT_EQ(sites[0]["name"], "hall");
  EXPECT_EQ(sites[0]["status"], "built");
  EXPECT_TRUE(sites[0]["error"].is_null());
  EXPECT_THAT(test::keys(sites[1]), testing::UnorderedElementsAre("name", "status", "error"));
  EXPECT_EQ(sites[1]["error"], "missing.sdf: no such file");
}

TEST_F(SitesCli, WritesTheMapThatItsOwnCommandWrites) {
  write_sites("  - {name: hall, scene: world.sdf, readings: [robust], headings: 2}\n");
  ASSERT_EQ(run(kSites).exit_code, 0);
  ASSERT_EQ(run({"map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "1",
                 "--resolution", "2", "--readings", "robust", "--headings", "2", "-o", "alone"})
                .exit_code,
            0);
  EXPECT_EQ(bytes("hall.tiff"), bytes("alone.tiff"));
  EXPECT_THAT(bytes("hall.yaml"), testing::ContainsRegex("inputs: [0-9a-f]{16}\n"));
}

TEST_F(SitesCli, KeepsWhatWasMadeOfTheSameInputsAndMakesTheRestAnew) {
  write_sites("  - {name: hall, scene: world.sdf}\n  - {name: yard, scene: world.sdf, seed: 2}\n");
  ASSERT_THAT(statuses(), ElementsAre("built", "built"));
  const std::string made = bytes("hall.tiff");
  EXPECT_THAT(statuses(), ElementsAre("kept", "kept"));
  folder.write("hall.tiff", made.substr(0, made.size() / 2));
  EXPECT_THAT(statuses(), ElementsAre("built", "kept")) << "a map that is damaged";
  EXPECT_EQ(bytes("hall.tiff"), made);
  write_sites("  - {name: hall, scene: world.sdf, seed: 3}\n  - {name: yard, scene: world.sdf, seed: 2}\n");
  EXPECT_THAT(statuses(), ElementsAre("built", "kept")) << "other options";
  EXPECT_NE(bytes("hall.tiff"), made);
  folder.write("world.sdf", bytes("world.sdf") + "\n");
  EXPECT_THAT(statuses(), ElementsAre("kept", "kept")) << "a file written anew with the same surfaces";
  std::string moved = bytes("world.sdf");
  moved.replace(moved.find("4 3 1.5"), 7, "4 2 1.5");
  folder.write("world.sdf", moved);
  EXPECT_THAT(statuses(), ElementsAre("built", "built")) << "another scene";
}

TEST_F(SitesCli, DrawsAPictureThatIsMissingOfAMapThatIsKept) {
  write_sites("  - {name: hall, scene: world.sdf}\n");
  ASSERT_THAT(statuses(), ElementsAre("built"));
  const std::string drawn = bytes("hall.png");
  std::filesystem::remove(folder / "hall.png");
  EXPECT_THAT(statuses(), ElementsAre("kept"));
  EXPECT_EQ(bytes("hall.png"), drawn);
}

TEST_F(SitesCli, GoesOnAfterAnInterruptWithTheSiteThatItWasAt) {
  write_sites("  - {name: hall, scene: world.sdf}\n  - {name: yard, scene: world.sdf, samples: 3000}\n  - {name: end, scene: world.sdf}\n");
  const test::Outcome outcome = test::run_program(kSites, folder / "", test::Signal{.after = 2.0, .number = SIGINT});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("and the same command goes on from there"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(exists("end.yaml"));
}

TEST_F(SitesCli, RefusesTheFileAtTheKeyAndOptionsThatAreTheFiles) {
  write_sites("  - {name: hall, scene: world.sdf, sample: 3}\n");
  test::Outcome outcome = run(kSites);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "sites.yaml:6:36: unknown key 'sample' (did you mean 'samples'?)\n");
  outcome = run(kSites, {"--samples", "3"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--samples excludes --sites"));
}

TEST_F(SitesCli, SaysOfASiteThatCannotBeWrittenOrIsUnderWay) {
  write_sites("  - {name: hall, scene: world.sdf, output: no/hall}\n  - {name: yard, scene: world.sdf}\n");
  folder.write("yard.part", "notes");
  const json sites = json::parse(run(kSites, {"--json"}).out);
  EXPECT_THAT(sites[0]["error"], HasSubstr("no/hall.part: cannot be written: No such file or directory"));
  EXPECT_THAT(sites[1]["error"], HasSubstr("yard.part: is not a checkpoint of ours"));
}

}  // namespace
}  // namespace alignability
