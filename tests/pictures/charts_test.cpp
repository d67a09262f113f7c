// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "pictures/chart.hpp"
#include "pictures/distribution_picture.hpp"
#include "pictures/trade_off_picture.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

using test::Picture;

class Charts : public testing::Test {
 protected:
  Picture drawn(std::span<const TradeOffPoint> points) const {
    draw_trade_off(points, "title", png);
    return Picture(png);
  }
  Picture drawn(std::span<const DistributionPanel> panels) const {
    draw_distributions(panels, "title", png);
    return Picture(png);
  }

  test::TemporaryFolder folder;
  std::filesystem::path png = folder / "chart.png";
};

TEST(Chart, PutsItsCornersAtTheEndsOfItsSpans) {
  const detail::Chart chart{{10.0, 20.0, 100.0, 50.0}, {1.0, 3.0}, {0.0, 10.0}};
  EXPECT_EQ(chart.at(1.0, 0.0), Eigen::Vector2d(10.0, 70.0));
  EXPECT_EQ(chart.at(3.0, 10.0), Eigen::Vector2d(110.0, 20.0));
  EXPECT_EQ(chart.at(2.0, 5.0), Eigen::Vector2d(60.0, 45.0));
}

TEST_F(Charts, ATradeOffIsALineWithADotAWeight) {
  const std::vector<TradeOffPoint> points{{0.0, 50.0, 40.0}, {1.0, 55.0, 10.0}, {5.0, 60.0, 0.0}};
  EXPECT_GT(drawn(points).count(kRiskAwareColour), 800);
  EXPECT_EQ(drawn(std::vector<TradeOffPoint>{}).count(kRiskAwareColour), 0);
}

TEST_F(Charts, APointOfNoLengthAndPointsAllAlikeAreDrawn) {
  EXPECT_GT(drawn(std::vector<TradeOffPoint>{{0.0, 0.0, 0.0}}).count(kRiskAwareColour), 50);
  EXPECT_GT(drawn(std::vector<TradeOffPoint>(5, {1.0, 10.0, 2.0})).count(kRiskAwareColour), 50);
}

TEST_F(Charts, ADistributionIsLowWhereFewValuesAreAndHighBehindThem) {
  const DistributionPanel panel{"ratio", {{"", {3.0, 3.0, 3.0, 3.0}, kRiskAwareColour, LineStyle::solid}}, 1.0};
  const Picture picture = drawn(std::vector<DistributionPanel>{panel});
  int first_high = -1;
  int last_low = -1;
  const int middle = picture.height() / 2;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (test::difference(picture.at({x + 0.5, y + 0.5}), kRiskAwareColour) > 0.02) continue;
      if (y < middle - 150 && first_high < 0) first_high = x;
      if (y > middle + 150) last_low = std::max(last_low, x);
    }
  }
  EXPECT_GT(first_high, picture.width() / 2);
  EXPECT_NEAR(first_high, last_low, 6.0);
}

TEST_F(Charts, ADistributionOfNothingIsAnEmptyFrame) {
  const Picture picture = drawn(std::vector<DistributionPanel>{{"ratio", {{"none", {}, kShortestColour, LineStyle::dashed}}, 0.0}});
  EXPECT_GT(picture.width(), 500);
}

TEST_F(Charts, AFileThatCannotBeWrittenIsAnInputErrorThatNamesIt) {
  EXPECT_THROW(draw_trade_off({}, "", folder / "no/such/folder.png"), InputError);
  EXPECT_THROW(draw_distributions({}, "", folder / "no/such/folder.png"), InputError);
}

}  // namespace
}  // namespace alignability
