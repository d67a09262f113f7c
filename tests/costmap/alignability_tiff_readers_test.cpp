// SPDX-License-Identifier: BSD-3-Clause
// The layers of a map as other programs read them from its TIFF.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <sstream>

#include "costmap/alignability_map.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

constexpr int kModuleAbsent = 77;

struct Printed {
  int exit_code = -1;
  std::string text;
};

// What Debian's Python prints of a TIFF; the one first on the path may lack the modules.
Printed print_tiff(const std::string& reader, const std::filesystem::path& tiff) {
  const std::string command = "/usr/bin/python3 " ALIGNABILITY_SOURCE_DIR "/tests/costmap/print_tiff.py " + reader + ' ' + tiff.string();
  std::FILE* pipe = ::popen(command.c_str(), "r");
  Printed printed;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) printed.text.append(buffer.data(), count);
  const int status = ::pclose(pipe);
  printed.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return printed;
}

AlignabilityMap random_map(int width, int height, int layers, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> alpha;
  AlignabilityMap map;
  map.geometry = {.resolution = 0.5, .origin = {-3.0, 7.5}, .width = width, .height = height};
  for (int k = 0; k < layers; ++k) {
    Grid<float> values(map.geometry, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < map.geometry.size(); ++i) {
      if (random() % 4 != 0) values[i] = alpha(random) - (k == 0 ? 0.0f : 0.5f);
    }
    map.layers.push_back({k == 0 ? "alpha" : "layer " + std::to_string(k), std::move(values)});
  }
  return map;
}

void expect_page(std::istream& page, const Grid<float>& layer) {
  int width = 0;
  int height = 0;
  std::string no_data;
  page >> width >> height >> no_data;
  ASSERT_EQ(width, layer.geometry().width);
  ASSERT_EQ(height, layer.geometry().height);
  EXPECT_EQ(no_data, "nan");
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      std::uint32_t bits = 0;
      page >> std::hex >> bits >> std::dec;
      ASSERT_TRUE(page) << x << ' ' << y;
      const float expected = layer[Cell{x, y}];
      const bool same = std::isnan(expected) ? std::isnan(std::bit_cast<float>(bits)) : bits == std::bit_cast<std::uint32_t>(expected);
      EXPECT_TRUE(same) << x << ' ' << y << ": " << std::bit_cast<float>(bits) << " for " << expected;
    }
  }
}

class AlignabilityTiff : public ::testing::TestWithParam<const char*> {};

TEST_P(AlignabilityTiff, HoldsTheSameInEveryPage) {
  const test::TemporaryFolder folder;
  constexpr struct { int width, height, layers; } kSizes[] = {{1, 1, 1}, {1, 1, 3}, {7, 1, 1}, {1, 9, 2}, {31, 17, 6}, {257, 130, 2}};
  for (const auto& [width, height, layers] : kSizes) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + " x " + std::to_string(layers));
    const AlignabilityMap map = random_map(width, height, layers, 11);
    write_alignability_map(map, folder / "a");
    const Printed printed = print_tiff(GetParam(), folder / "a.tiff");
    if (printed.exit_code == kModuleAbsent) GTEST_SKIP() << "/usr/bin/python3 has no module for " << GetParam();
    ASSERT_EQ(printed.exit_code, 0);
    std::istringstream pages(printed.text);
    for (const AlignabilityMap::Layer& layer : map.layers) expect_page(pages, layer.values);
    std::string more;
    EXPECT_FALSE(pages >> more) << "a page too many";
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, AlignabilityTiff, ::testing::Values("pillow", "gdal"));

}  // namespace
}  // namespace alignability
