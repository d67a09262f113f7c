// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/alignability_difference_picture.hpp"

#include <gmock/gmock.h>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/ascii_map.hpp"
#include "tests/pictures/read_png.hpp"

namespace alignability {
namespace {

const GridGeometry kFour{.resolution = 1.0, .origin = {0.0, 0.0}, .width = 4, .height = 1};
const OccupancyMap kOpen = test::ascii_map(1.0, {"...."});

// A fall by 0.4, no change, a rise by 0.4, and nothing to compare.
MapComparison small_comparison() {
  MapComparison comparison;
  for (const auto& [x, second] : {std::pair{0, 0.1}, {1, 0.5}, {2, 0.9}}) {
    comparison.cells.push_back({.cell = {x, 0}, .center = {x + 0.5, 0.5}, .first = 0.5, .second = second, .is_lower = x == 0});
  }
  comparison.magnitude.max = 0.4;
  return comparison;
}

TEST(AlignabilityDifferencePicture, IsRedWhereAlphaFellAndBlueWhereItRose) {
  const test::TemporaryFolder folder;
  draw_alignability_difference(small_comparison(), kFour, kOpen, "after against before", folder / "a.png");
  const test::Picture picture(folder / "a.png");
  const int cell = 120 * 120;
  EXPECT_NEAR(picture.count(colour_from_hex(0x67001f)), cell - 4 * 3 * 120, 0.05 * cell) << "framed, for it is lower";
  EXPECT_NEAR(picture.count(colour_from_hex(0x053061)), cell, 0.05 * cell);
  EXPECT_NEAR(picture.count(colour_from_hex(0xd2d2d2)), cell, 0.1 * cell);
}

TEST(AlignabilityDifferencePicture, AFileThatCannotBeWrittenIsNamed) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::thrown_message([&] { draw_alignability_difference(small_comparison(), kFour, kOpen, "", folder / "no/a.png"); }),
              ::testing::StartsWith((folder / "no/a.png").string() + ": cannot be written"));
}

}  // namespace
}  // namespace alignability
