// SPDX-License-Identifier: BSD-3-Clause
#include "report/packed_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace alignability::detail {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string base64(std::string_view text) { return to_base64(std::vector<std::uint8_t>(text.begin(), text.end())); }

GridGeometry cells(int width, int height) { return {.resolution = 0.5, .origin = {1.0, -2.0}, .width = width, .height = height}; }

// The test vectors of RFC 4648, section 10.
TEST(PackedGrid, WritesBase64AsTheRfcHasIt) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(PackedGrid, PacksSharesLittleEndFirstAndKeepsWhatHasNoValue) {
  const Grid<double> values(cells(4, 1), {0.0, 1.0, 0.5, kNan});
  EXPECT_EQ(packed_shares(values), base64(std::string_view("\x00\x00\xfe\xff\xff\x7f\xff\xff", 8)));
}

TEST(PackedGrid, PacksFourCellsOfAMapInAByte) {
  const OccupancyMap map(Grid<float>(cells(5, 1), {0.0f, 1.0f, std::numeric_limits<float>::quiet_NaN(), 0.2f, 0.9f}));
  EXPECT_EQ(packed_occupancy(map), base64(std::string_view("\x18\x02", 2)));
}

TEST(PackedGrid, PacksEightBitsInAByte) {
  EXPECT_EQ(packed_bits(9, [](std::size_t i) { return i == 0 || i == 8; }), base64("\x01\x01"));
}

TEST(PackedGrid, TakesAsFewCellsToABlockAsItMay) {
  EXPECT_EQ(reduced(cells(8, 3), 8), cells(8, 3));
  const GridGeometry blocks = reduced(cells(9, 3), 4);
  EXPECT_EQ(blocks.width, 3);
  EXPECT_EQ(blocks.height, 1);
  EXPECT_DOUBLE_EQ(blocks.resolution, 1.5);
  EXPECT_EQ(blocks.origin, cells(9, 3).origin);
}

TEST(PackedGrid, KeepsTheWorstOfABlock) {
  const Grid<double> alpha(cells(4, 2), {0.9, 0.4, kNan, kNan, 0.7, kNan, kNan, kNan});
  const Grid<double> least = least_by_block(alpha, reduced(alpha.geometry(), 2));
  ASSERT_EQ(least.values().size(), 2u);
  EXPECT_EQ(least[0], 0.4);
  EXPECT_TRUE(std::isnan(least[1]));

  const float unknown = std::numeric_limits<float>::quiet_NaN();
  const OccupancyMap map(Grid<float>(cells(6, 2), {0.0f, 0.0f, 0.0f, unknown, unknown, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, unknown}));
  const OccupancyMap worst = worst_by_block(map, reduced(map.geometry(), 3));
  EXPECT_TRUE(worst.is_free(std::size_t{0}));
  EXPECT_EQ(worst.occupancy({1, 0}), std::nullopt);
  EXPECT_EQ(worst.occupancy({2, 0}), 1.0f);
}

}  // namespace
}  // namespace alignability::detail
