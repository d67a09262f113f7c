// SPDX-License-Identifier: BSD-3-Clause
// What nav2's own loader (nav2_map_server's map_io.cpp, from Foxy to Jazzy) makes of a pixel, worked out by hand from its rules.
#include <gmock/gmock.h>

#include <cmath>

#include "costmap/map_server.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/images.hpp"

namespace alignability {
namespace {

using test::PngKind;

constexpr int kUnknown = -1;

// The cells of the bottom row in percent, as in nav2's OccupancyGrid.
std::vector<int> percents(const OccupancyMap& map) {
  std::vector<int> row;
  for (int x = 0; x < map.geometry().width; ++x) {
    const auto occupancy = map.occupancy({x, 0});
    row.push_back(occupancy ? static_cast<int>(std::lround(100.0f * *occupancy)) : kUnknown);
    EXPECT_EQ(occupancy.value_or(-0.01f), static_cast<float>(row.back() / 100.0)) << "no whole percentage, at " << x;
  }
  return row;
}

std::string yaml(const std::string& rules) { return "image: map\nresolution: 0.05\norigin: [0, 0, 0]\n" + rules; }

struct Thresholds {
  const char* mode;
  int negate = 0;
  double occupied = 0.65;
  double free = 0.196;

  std::string yaml() const {
    std::ostringstream text;
    text << "mode: " << mode << "\nnegate: " << negate << "\noccupied_thresh: " << occupied << "\nfree_thresh: " << free << "\n";
    return text.str();
  }
};

// Of the shades from 0 to 255, the last one of each stretch of equal cells.
struct Stretch {
  int last_shade;
  int percent;
};

struct RampCase {
  Thresholds rules;
  std::vector<Stretch> stretches;
};

class Nav2Trinary : public ::testing::TestWithParam<RampCase> {};

TEST_P(Nav2Trinary, ClassesEveryShade) {
  std::vector<int> shades;
  for (int shade = 0; shade < 256; ++shade) shades.push_back(shade);
  std::vector<int> expected;
  for (const Stretch& stretch : GetParam().stretches) expected.resize(static_cast<std::size_t>(stretch.last_shade) + 1, stretch.percent);
  const test::TemporaryFolder folder;
  folder.write("map", test::pgm(256, shades));
  EXPECT_EQ(percents(read_occupancy_map(folder.write("map.yaml", yaml(GetParam().rules.yaml())))), expected);
}

// A shade g is as dark as 1 - g/255, g/255 when negated. Darker than occupied_thresh is occupied, lighter than free_thresh free; what
// meets a threshold is unknown: 51, 102 and 153 of 255 are 0.2, 0.4 and 0.6 exactly. But 1 - 0.8 is a hair below 0.2.
INSTANTIATE_TEST_SUITE_P(Table, Nav2Trinary,
                         ::testing::Values(RampCase{{"trinary", 0, 0.65, 0.196}, {{89, 100}, {205, kUnknown}, {255, 0}}},
                                           RampCase{{"trinary", 0, 0.65, 0.25}, {{89, 100}, {191, kUnknown}, {255, 0}}},
                                           RampCase{{"trinary", 0, 0.6, 0.4}, {{101, 100}, {153, kUnknown}, {255, 0}}},
                                           RampCase{{"trinary", 0, 0.6, 0.2}, {{101, 100}, {203, kUnknown}, {255, 0}}},
                                           RampCase{{"trinary", 0, 0.8, 0.1}, {{50, 100}, {229, kUnknown}, {255, 0}}},
                                           RampCase{{"trinary", 0, 1.0, 0.0}, {{255, kUnknown}}},
                                           RampCase{{"trinary", 1, 0.65, 0.196}, {{49, 0}, {165, kUnknown}, {255, 100}}},
                                           RampCase{{"trinary", 1, 0.65, 0.25}, {{63, 0}, {165, kUnknown}, {255, 100}}},
                                           RampCase{{"trinary", 1, 0.6, 0.2}, {{50, 0}, {153, kUnknown}, {255, 100}}},
                                           RampCase{{"trinary", 1, 1.0, 0.0}, {{255, kUnknown}}}));

struct PnmCase {
  Thresholds rules;
  std::string image;
  std::vector<int> percents;
};

class Nav2Pnm : public ::testing::TestWithParam<PnmCase> {};

TEST_P(Nav2Pnm, ReadsEveryValue) {
  const test::TemporaryFolder folder;
  folder.write("map", GetParam().image);
  EXPECT_EQ(percents(read_occupancy_map(folder.write("map.yaml", yaml(GetParam().rules.yaml())))), GetParam().percents);
}

const std::vector<int> kRawPercents{0, 50, 51, 100, kUnknown, kUnknown, kUnknown};

INSTANTIATE_TEST_SUITE_P(
    Table, Nav2Pnm,
    ::testing::Values(
        // Scale: between the thresholds 100·(occupancy - free_thresh)/(occupied_thresh - free_thresh), rounded; both ends meet it.
        PnmCase{{"scale", 0, 0.8, 0.2}, "P2 9 1 255 255 204 203 153 128 102 52 51 0", {0, 0, 1, 33, 50, 67, 99, 100, 100}},
        PnmCase{{"scale", 1, 0.8, 0.2}, "P2 6 1 255 0 51 53 102 204 255", {0, 0, 1, 33, 100, 100}},
        PnmCase{{"scale", 0, 0.65, 0.196}, "P2 6 1 255 0 89 90 205 206 254", {100, 100, 99, 0, 0, 0}},
        PnmCase{{"scale", 0, 1.0, 0.0}, "P2 5 1 255 255 254 128 1 0", {0, 0, 50, 100, 100}},
        // Raw: the value itself, whatever the thresholds and negate say; above 100 unknown.
        PnmCase{{"raw", 0, 0.65, 0.196}, "P2 7 1 255 0 50 51 100 101 205 255", kRawPercents},
        PnmCase{{"raw", 1, 0.65, 0.196}, "P2 7 1 255 0 50 51 100 101 205 255", kRawPercents},
        PnmCase{{"raw", 0, 0.2, 0.1}, "P5 7 1 255 " + std::string("\x00\x32\x33\x64\x65\xcd\xff", 7), kRawPercents},
        // 16 bits: 257 times the value of 8; in a binary file the high byte first. 0.65 lies between 22937 and 22938.
        PnmCase{{"raw"}, "P2 7 1 65535 0 12850 13107 25700 25957 52685 65535", kRawPercents},
        PnmCase{{"raw"}, "P5 7 1 65535 " + std::string("\x00\x00\x32\x32\x33\x33\x64\x64\x65\x65\xcd\xcd\xff\xff", 14), kRawPercents},
        PnmCase{{"trinary"}, "P2 5 1 65535 0 22937 22938 52685 65280", {100, 100, kUnknown, kUnknown, 0}},
        PnmCase{{"trinary"}, "P5 3 1 65535 " + std::string("\x00\xff\xcd\xcd\xff\x00", 6), {100, kUnknown, 0}},
        // White that is not 255.
        PnmCase{{"scale", 0, 1.0, 0.0}, "P2 4 1 100 0 50 85 100", {100, 50, 15, 0}},
        PnmCase{{"scale", 0, 1.0, 0.0}, "P5 4 1 100 " + std::string("\x00\x32\x55\x64", 4), {100, 50, 15, 0}},
        PnmCase{{"scale", 0, 1.0, 0.0}, "P2 3 1 1000 0 500 1000", {100, 50, 0}}, PnmCase{{"trinary"}, "P2 4 1 1 0 1 1 0", {100, 0, 0, 100}},
        // Comments in the header, of a text between the values too; Windows' line ends.
        PnmCase{{"trinary"}, "P2\n# CREATOR\n3 1\n# white\n255\n0 # black\n205 254\n", {100, kUnknown, 0}},
        PnmCase{{"trinary"}, "P2\r\n3 1\r\n255\r\n0 205\r\n254\r\n", {100, kUnknown, 0}},
        PnmCase{{"trinary"}, "P5 # CREATOR: map_saver.cpp\n3 # wide\n1\n255\n" + std::string("\x00\xcd\xfe", 3), {100, kUnknown, 0}},
        // What follows the one space after white is a pixel, be it a number sign: 35 of 255 is dark.
        PnmCase{{"trinary"}, "P5\n2 1\n255\n#\xfe", {100, 0}},
        // Colours: their mean. 267/3 = 89 is darker than 0.65, 270/3 = 90 is not; 615/3 = 205, 618/3 = 206.
        PnmCase{{"trinary"}, "P3 4 1 255 0 12 255 0 15 255 255 255 105 255 255 108", {100, kUnknown, kUnknown, 0}},
        PnmCase{{"raw"}, "P3 5 1 255 0 50 100 1 0 0 1 1 0 100 100 101 100 101 101", {50, 0, 1, 100, kUnknown}}));

struct PngCase {
  Thresholds rules;
  PngKind kind;
  int width;
  std::vector<int> channels;
  std::vector<int> percents;
};

class Nav2Png : public ::testing::TestWithParam<PngCase> {};

TEST_P(Nav2Png, ReadsEveryPixel) {
  const test::TemporaryFolder folder;
  test::write_png(folder / "map", GetParam().kind, GetParam().width, GetParam().channels);
  EXPECT_EQ(percents(read_occupancy_map(folder.write("map.yaml", yaml(GetParam().rules.yaml())))), GetParam().percents);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Nav2Png,
    ::testing::Values(PngCase{{"trinary"}, PngKind::grey, 5, {89, 90, 205, 206, 255}, {100, kUnknown, kUnknown, 0, 0}},
                      PngCase{{"trinary", 0, 0.65, 0.25}, PngKind::grey, 3, {191, 192, 205}, {kUnknown, 0, 0}},
                      PngCase{{"trinary"}, PngKind::grey16, 4, {22937, 22938, 257 * 205, 257 * 206}, {100, kUnknown, kUnknown, 0}},
                      PngCase{{"trinary"}, PngKind::rgb, 3, {0, 12, 255, 0, 15, 255, 255, 255, 108}, {100, kUnknown, 0}},
                      // Trinary: the alpha is one more colour, so that what is opaque is lighter: (3·34 + 255)/4 is 0.35 of white.
                      PngCase{{"trinary"},
                              PngKind::rgba,
                              6,
                              {0, 0, 0, 255, 33, 33, 33, 255, 34, 34, 34, 255, 205, 205, 205, 255, 254, 254, 254, 0, 0, 0, 0, 0},
                              {100, 100, kUnknown, 0, kUnknown, 100}},
                      PngCase{{"trinary", 1}, PngKind::rgba, 3, {0, 0, 0, 255, 0, 0, 0, 0, 255, 255, 255, 0}, {kUnknown, 0, 100}},
                      PngCase{{"trinary"}, PngKind::grey_alpha, 3, {0, 255, 205, 255, 254, 0}, {100, 0, kUnknown}},
                      // Scale: what is not opaque is unknown, and the alpha no colour.
                      PngCase{{"scale"},
                              PngKind::rgba,
                              5,
                              {0, 0, 0, 255, 205, 205, 205, 255, 255, 255, 255, 254, 255, 255, 255, 0, 0, 0, 0, 254},
                              {100, 0, kUnknown, kUnknown, kUnknown}},
                      PngCase{{"scale"}, PngKind::grey_alpha, 3, {0, 255, 254, 255, 254, 254}, {100, 0, kUnknown}},
                      PngCase{{"scale"}, PngKind::grey_keyed, 3, {0, 255, test::kTransparentShade}, {100, 0, kUnknown}},
                      PngCase{{"trinary"}, PngKind::grey_keyed, 4, {0, 34, 255, test::kTransparentShade}, {100, kUnknown, 0, kUnknown}},
                      // Raw: the alpha says nothing.
                      PngCase{{"raw"}, PngKind::rgba, 3, {50, 50, 50, 0, 0, 50, 100, 255, 101, 101, 101, 128}, {50, 50, kUnknown}},
                      PngCase{{"raw", 1}, PngKind::grey_alpha, 2, {100, 0, 101, 255}, {100, kUnknown}}));

}  // namespace
}  // namespace alignability
