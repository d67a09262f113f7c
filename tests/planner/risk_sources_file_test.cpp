// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "costmap/clearance_map.hpp"
#include "costmap/map_server.hpp"
#include "planner/plan.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

constexpr const char* kHead = "map: m.yaml\nalignability: a.yaml\nrobot: {radius: 0.2}\nstart: [1, 1, 0]\ngoal: [7, 1, 0]\n";
constexpr const char* kSources =
    "risk:\n"
    "  weight: 4\n"
    "  sources:\n"
    "    alignability: {weight: 0.5}\n"
    "    clearance: {weight: 0.25, risky: 0.3, safe: 1}\n"
    "    traffic: {weight: 2, raster: traffic.yaml, risky: 0.9, safe: 0.1, unknown: neutral}\n"
    "    spread: {weight: 1, raster: a.yaml, layer: iqr, risky: 0.2, safe: 0}\n"
    "    speed: {weight: 0, raster: speed.tiff, resolution: 2, origin: [-1, 0], risky: 1.5, safe: 0.5}\n";

// A hall of 8 × 4 m, and rasters that cover it.
// By append, for g++ 12 takes + under ThreadSanitizer for overlapping copies.
std::string with_sources() { return std::string(kHead).append(kSources); }

class RiskSourcesFile : public testing::Test {
 protected:
  RiskSourcesFile() {
    write_occupancy_map(OccupancyMap(Grid<float>({.resolution = 0.5, .width = 16, .height = 8}, 0.0f)), folder / "m");
    AlignabilityMap map;
    map.geometry = {.resolution = 1.0, .width = 8, .height = 4};
    map.layers = {{"alpha", Grid<float>(map.geometry, 0.9f)}, {"iqr", Grid<float>(map.geometry, 0.1f)}};
    write_alignability_map(map, folder / "a");
    folder.write("traffic.pgm", "P5 2 1 255\n" + std::string{'\x00', '\xff'});
    folder.write("traffic.yaml",
                 "image: traffic.pgm\nresolution: 4\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.1\nmode: scale\n");
    map.geometry = {.resolution = 1.0, .width = 5, .height = 2};
    map.layers = {{"alpha", Grid<float>(map.geometry, 1.0f)}};
    write_alignability_map(map, folder / "speed");
  }

  ProblemFile read(const std::string& text) const {
    write_file(file, text);
    return read_problem_file(file);
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder / "problem.yaml";
};

TEST_F(RiskSourcesFile, NamesSourcesWithTheirWeightsAndThresholds) {
  const RiskOptions risk = read(with_sources()).query.risk;
  EXPECT_EQ(risk.alpha_weight, 0.5);
  EXPECT_EQ(names_of_risks(risk), (std::vector<std::string>{"alignability", "clearance", "traffic", "spread", "speed"}));
  EXPECT_EQ(risk.sources[0].weight, 0.25);
  EXPECT_EQ(risk.sources[0].risky, 0.3);
  EXPECT_EQ(risk.sources[0].safe, 1.0);
  EXPECT_FALSE(risk.sources[0].file.has_value());
  EXPECT_EQ(risk.sources[1].file->file, folder / "traffic.yaml");
  EXPECT_EQ(risk.sources[1].unknown, UnknownPolicy::neutral);
  EXPECT_EQ(risk.sources[2].file->layer, "iqr");
  EXPECT_EQ(risk.sources[2].unknown, UnknownPolicy::risky);
  EXPECT_EQ(risk.sources[3].file->place->resolution, 2.0);
  EXPECT_EQ(risk.sources[3].file->place->origin, Eigen::Vector2d(-1.0, 0.0));
}

TEST_F(RiskSourcesFile, AddUpOnceTheMapsAreRead) {
  const PlanProblem problem = load_problem(read(with_sources()));
  const PlanningFields fields(problem);
  ASSERT_EQ(fields.risk->layers().size(), 5u);
  // α is safe; the clearance of (2, 2) is 2 m; traffic's left half is risky; iqr is half of the way; the speed weighs nothing.
  EXPECT_NEAR(fields.risk->risk(2.0, 2.0, 0.0), 2.0 + 0.5, 1e-6);
  EXPECT_NEAR(fields.risk->risk(2.0, 0.5, 0.0), 2.0 + 0.5 + 0.25 * 0.5 / 0.7, 1e-6);
  EXPECT_NEAR(fields.risk->layers()[4].risk.at({2.0, 2.0}), 0.5, 1e-6);
  const PlanResult result = plan(problem.query, fields, {});
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_NEAR(result.cost, result.figures.length + 4.0 * result.figures.risk_integral + 0.2 * result.figures.turned, 1e-9);
  EXPECT_GE(result.cost, *result.lower_bound);
}

TEST_F(RiskSourcesFile, AreWrittenOutAsTheyWereRead) {
  const PlanQuery query = read(with_sources()).query;
  EXPECT_EQ(to_yaml(read("map: m.yaml\nalignability: a.yaml\n" + to_yaml(query)).query), to_yaml(query));
  EXPECT_EQ(to_yaml(read(kHead).query).find("sources"), std::string::npos) << "as without them";
  const PlanQuery odd =
      read(std::string(kHead) + "risk: {sources: {odd: {weight: 1, raster: 'a \"b\" \\ c.yaml', risky: 1, safe: 0}}}\n").query;
  EXPECT_EQ(read("map: m.yaml\nalignability: a.yaml\n" + to_yaml(odd)).query.risk.sources.front().file->file,
            odd.risk.sources.front().file->file);
}

TEST_F(RiskSourcesFile, AreRefusedAtTheLineAndColumnOfWhatIsWrong) {
  struct Fault {
    const char* from;
    const char* to;
    const char* message;
  };
  const Fault faults[] = {
      {"sources:", "source:", "problem.yaml:8:3: unknown key 'source' (did you mean 'sources'?)"},
      {"alignability: {weight: 0.5}", "alignability: {weight: -0.5}", "problem.yaml:9:28: 'weight' must be from 0 to 1e+09, not -0.5"},
      {"alignability: {weight: 0.5}", "alignability: {weight: 1, safe: 1}", "problem.yaml:9:31: unknown key 'safe'"},
      {"clearance: {", "clearence: {", "problem.yaml:10:16: 'clearence' has no 'raster', and is no source of our own (did you mean"},
      {"weight: 0.25, ", "", "problem.yaml:10:16: missing key 'weight'"},
      {"weight: 0.25", "weight: .inf", "problem.yaml:10:25: 'weight' must be from 0 to 1e+09, not .inf"},
      {"safe: 1}", "safe: 0.3}", "problem.yaml:10:49: 'risky' and 'safe' must differ"},
      {"risky: 0.3", "risky: -1", "'risky' must be at least 0, not -1"},
      {"safe: 1}", "safe: 1, unknown: risky}", "problem.yaml:10:52: unknown key 'unknown'"},
      {"safe: 1}", "safe: 1, raster: traffic.yaml}", "unknown key 'raster'"},
      {"raster: traffic.yaml", "rastr: traffic.yaml", "problem.yaml:11:26: unknown key 'rastr' (did you mean 'raster'?)"},
      {"raster: traffic.yaml, ", "", "problem.yaml:11:14: missing key 'raster'"},
      {"risky: 0.9", "risky: .nan", "'risky' must be a finite number, not .nan"},
      {"unknown: neutral", "unknown: blocked", "'unknown' is 'blocked', which is none of: risky, neutral"},
      {"traffic: {", "clearance: {", "problem.yaml:11:5: key 'clearance' is given twice"},
      {"traffic: {", "the traffic: {", "the name of a source must be made of letters, digits, '_' and '-'"},
      {"layer: iqr", "resolution: 1", "problem.yaml:12:53: 'resolution' belongs to a .tiff"},
      {"resolution: 2, ", "", "problem.yaml:13:12: missing key 'resolution'"},
      {"resolution: 2", "resolution: 0", "'resolution' must be greater than 0, not 0"},
      {"origin: [-1, 0]", "origin: [-1]", "'origin' must be a list of 2 numbers, not 1"},
  };
  for (const Fault& fault : faults) {
    const std::string text = replaced(with_sources(), fault.from, fault.to);
    const std::string message = test::thrown_message([&] { read(text); });
    EXPECT_NE(message.find(fault.message), std::string::npos) << fault.to << " gave: " << message;
  }
}

TEST_F(RiskSourcesFile, AreRefusedWhereARasterCannotServe) {
  const auto refusal = [&](const char* from, const char* to) {
    const ProblemFile problem = read(replaced(with_sources(), from, to));
    return test::thrown_message([&] { load_problem(problem); });
  };
  EXPECT_EQ(refusal("origin: [-1, 0]", "origin: [1, 0]"),
            file.string() + ":13:32: the raster, x 1 to 11 and y 0 to 4, does not cover the map, x 0 to 8 and y 0 to 4");
  EXPECT_NE(refusal("layer: iqr", "layer: weak").find("a.yaml: has no layer 'weak'"), std::string::npos);
  EXPECT_NE(refusal("raster: speed.tiff", "raster: none.tiff").find("none.tiff: "), std::string::npos);
  EXPECT_NE(refusal("raster: traffic.yaml", "raster: none.yaml").find("none.yaml: no such file"), std::string::npos);
}

}  // namespace
}  // namespace alignability
