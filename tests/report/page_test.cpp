// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/report/sample_report.hpp"

namespace alignability {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const test::SampleReport& sample) { return to_html(sample.report, sample.problem, sample.risk()); }

// What the page's script reads.
json data_of(const std::string& page) {
  const std::string opening = R"(<script id="report" type="application/json">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Page, HoldsThePathsTheirFiguresAndErrors) {
  const test::SampleReport sample = test::sample_report();
  const json data = data_of(page_of(sample));
  ASSERT_EQ(data["paths"].size(), 2u);
  const json& shortest = data["paths"][0];
  EXPECT_EQ(shortest["name"], "shortest");
  EXPECT_EQ(shortest["dashed"], true);
  EXPECT_NEAR(shortest["blind"].get<double>(), sample.report.paths[0].figures.blind_length, 1e-4);
  EXPECT_EQ(shortest["samples"].size(), sample.report.paths[0].samples.size());
  EXPECT_EQ(shortest["errors"][1]["localizer"], "scan_matching");
  EXPECT_EQ(shortest["errors"][0]["profile"][2], json::array({1.0, 0.05, 0.075}));
  EXPECT_EQ(data["command"], "alignability report 'two corridors.yaml'");
}

TEST(Page, AsksNoNetwork) {
  const std::string page = page_of(test::sample_report());
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  // The one address is the name of SVG, which is fetched by no one.
  EXPECT_EQ(page.find("http"), page.find("http-equiv"));
  EXPECT_EQ(page.rfind("http"), page.find("http://www.w3.org/2000/svg"));
}

TEST(Page, IsTheSameBytesForTheSameReport) { EXPECT_EQ(page_of(test::sample_report()), page_of(test::sample_report())); }

TEST(Page, LetsNoTextOutOfItsPlace) {
  test::SampleReport sample = test::sample_report();
  sample.report.title = "</title><script>alert(1)</script>";
  sample.report.command = "</script><script>alert(2)</script> @script@ @report@";
  sample.report.paths[0].name = "<img onerror=alert(3)>";
  const std::string page = page_of(sample);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title>&lt;script>alert(1)&lt;/script></title>"));
  EXPECT_EQ(data_of(page)["command"], sample.report.command);
}

TEST(Page, MendsTextThatIsNoUtf8) {
  test::SampleReport sample = test::sample_report();
  sample.report.title = "caf\xe9";
  sample.report.command = "caf\xe9";
  const std::string page = page_of(sample);
  EXPECT_THAT(page, HasSubstr("<title>caf\xef\xbf\xbd</title>"));
  EXPECT_EQ(data_of(page)["command"], "caf\xef\xbf\xbd");
}

TEST(Page, HoldsAFieldAHeading) {
  const json data = data_of(page_of(test::sample_report_by_heading()));
  EXPECT_EQ(data["alpha"]["fields"].size(), 8u);
  EXPECT_EQ(data_of(page_of(test::sample_report()))["alpha"]["fields"].size(), 1u);
}

TEST(Page, ShowsAMapWithoutPaths) {
  test::SampleReport sample = test::sample_report();
  sample.report.paths.clear();
  EXPECT_EQ(data_of(page_of(sample))["paths"], json::array());
}

TEST(Page, WritesNothingThatIsNoNumber) {
  test::SampleReport sample = test::sample_report();
  sample.report.paths[0].figures.alpha_mean = std::numeric_limits<double>::quiet_NaN();
  sample.report.paths[0].samples[3].alpha = std::numeric_limits<double>::quiet_NaN();
  const json data = data_of(page_of(sample));
  EXPECT_TRUE(data["paths"][0]["alpha_mean"].is_null());
  EXPECT_TRUE(data["paths"][0]["samples"][3][4].is_null());
}

TEST(Page, DrawsAMapOfManyCellsByBlocks) {
  test::SampleReport sample = test::sample_report();
  const GridGeometry wide{.resolution = 0.005, .origin = {0.0, 0.0}, .width = 4100, .height = 20};
  Grid<float> occupancy(wide, 0.0f);
  occupancy[Cell{4099, 19}] = 1.0f;
  sample.problem.occupancy = OccupancyMap(std::move(occupancy));
  const json data = data_of(page_of(sample));
  EXPECT_EQ(data["occupancy"]["width"], 1367);
  EXPECT_EQ(data["occupancy"]["cell"], 0.005);
  EXPECT_NEAR(data["occupancy"]["resolution"].get<double>(), 0.015, 1e-12);
}

}  // namespace
}  // namespace alignability
