// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/json_keys.hpp"
#include "tests/cli/program.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::filesystem::path kSite = std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "maps/warehouse";
const std::string kProblem = kSite / "several_risks.yaml";

class RiskSourcesCli : public testing::Test {
 protected:
  test::Outcome run(const std::vector<std::string>& arguments) const { return test::run_program(arguments, folder / ""); }
  std::string text(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TemporaryFolder folder;
};

std::vector<double> numbers(const std::string& line) {
  std::vector<double> values;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) values.push_back(std::stod(field));
  return values;
}

TEST_F(RiskSourcesCli, ArePlannedForAndToldApart) {
  const test::Outcome outcome = run({"plan", kProblem, "-o", "route"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nrisk integral "));
  for (const char* row : {"\nrisk, alignability ", "\nrisk, clearance ", "\nrisk, traffic "}) EXPECT_THAT(outcome.out, HasSubstr(row));
  EXPECT_TRUE(text("route.png").starts_with("\x89PNG"));
  const json plan = json::parse(text("route.json"));
  const json& risks = plan["risk_by_source"];
  EXPECT_THAT(test::keys(risks), testing::UnorderedElementsAre("alignability", "clearance", "traffic"));
  const double sum = risks["alignability"].get<double>() + 0.1 * risks["clearance"].get<double>() + 0.5 * risks["traffic"].get<double>();
  EXPECT_NEAR(plan["risk_integral"].get<double>(), sum, 1e-9);
  EXPECT_LE(plan["lower_bound"].get<double>(), plan["cost"].get<double>());
  const json& sources = plan["options"]["risk"]["sources"];
  EXPECT_EQ(sources["alignability"], json({{"weight", 1.0}}));
  EXPECT_EQ(sources["clearance"], json({{"weight", 0.1}, {"risky", 0.7}, {"safe", 1.5}}));
  EXPECT_EQ(sources["traffic"]["raster"], (kSite / "traffic.yaml").string());
  EXPECT_EQ(sources["traffic"]["unknown"], "risky");

  std::istringstream csv(text("route.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "x,y,yaw,s,alpha,risk,risk_alignability,risk_clearance,risk_traffic");
  while (std::getline(csv, line)) {
    const std::vector<double> at = numbers(line);
    ASSERT_EQ(at.size(), 9u);
    EXPECT_NEAR(at[5], at[6] + 0.1 * at[7] + 0.5 * at[8], 1e-12);
  }
  const json scored = json::parse(run({"evaluate", "route.csv", "--problem", kProblem, "--json"}).out);
  for (const char* source : {"alignability", "clearance", "traffic"}) {
    EXPECT_NEAR(scored["risk_by_source"][source].get<double>(), risks[source].get<double>(), 1e-9) << source;
  }
}

TEST_F(RiskSourcesCli, AreComparedWithTheShortestPath) {
  const test::Outcome outcome = run({"compare", kProblem, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json both = json::parse(outcome.out);
  EXPECT_EQ(both["shortest"]["weight"], 0.0);
  EXPECT_GT(both["shortest"]["risk_by_source"]["alignability"].get<double>(), 35.0) << "through the corridor all the same";
  EXPECT_LT(both["risk_aware"]["risk_integral"].get<double>(), both["shortest"]["risk_integral"].get<double>());
  EXPECT_THAT(run({"compare", kProblem}).out, HasSubstr("\nrisk, traffic "));
}

TEST_F(RiskSourcesCli, GiveEachEdgeOfAGraphItsColumns) {
  ASSERT_EQ(run({"evaluate", kSite / "lanes.geojson", "--problem", kProblem, "-o", "lanes"}).exit_code, 0);
  const std::string lanes = text("lanes.csv");
  EXPECT_THAT(lanes.substr(0, lanes.find('\n')), testing::EndsWith(",alpha_mean,alpha_min,risk_alignability,risk_clearance,risk_traffic"));
  EXPECT_TRUE(json::parse(text("lanes.json"))["edges"][0].contains("risk_by_source"));
}

TEST_F(RiskSourcesCli, AreRefusedWhereTheirRasterEndsBeforeTheMap) {
  const std::string site = kSite.string();
  folder.write("small.pgm", "P2 1 1 255 0\n");
  folder.write("small.yaml", "image: small.pgm\nresolution: 40\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  folder.write("small_problem.yaml", "map: " + site + "/occupancy.yaml\nalignability: " + site +
                                         "/alignability.yaml\nrobot: {radius: 0.6}\nstart: [5, 20, 0]\ngoal: [55, 20, 0]\n"
                                         "risk:\n  sources:\n    traffic: {weight: 1, raster: small.yaml, risky: 1, safe: 0}\n");
  const test::Outcome outcome = run({"plan", "small_problem.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "small_problem.yaml:8:34: the raster, x 0 to 40 and y 0 to 40, does not cover the map, x 0 to 60 and y 0 to 45\n");
}

}  // namespace
}  // namespace alignability
