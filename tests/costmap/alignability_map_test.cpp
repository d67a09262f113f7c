// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/alignability_map.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <random>

#include "core/file.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/costmap/tiff_files.hpp"

namespace alignability {
namespace {

using test::TemporaryFolder;
using test::write_tiff;
using ::testing::HasSubstr;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

AlignabilityMap small_map() {
  const GridGeometry geometry{.resolution = 0.1, .origin = {-15.1, 0.30000000000000004}, .width = 3, .height = 2};
  AlignabilityMap map;
  map.geometry = geometry;
  map.layers.push_back({"alpha", Grid<float>(geometry, {0.0f, 0.1f, 1.0f, kNone, 0.5f, 0.25f})});
  map.layers.push_back({"weak_x", Grid<float>(geometry, {-1.0f, 0.0f, 1e30f, kNone, -0.0f, 1e-40f})});
  map.seed = 7;
  map.options = "samples: 10\no_max: 0.5\n";
  map.sensor = "name: Velodyne HDL-32E\nrange: {min: 0.5, max: 100}   # a comment\n";
  map.provenance = "scene: warehouse.sdf\n";
  map.error_model = {.growth = 0.021,
                     .recovery = 3.5,
                     .least = 0.01,
                     .alpha_poor = 0.05,
                     .alpha_rich = 0.3,
                     .calibration = {.localizer = "ndt_mcl_sum", .sensor = "HDL: 32", .noise = 0.008, .range_max = 6.5, .scale_bias = -0.02}};
  return map;
}

AlignabilityMap again(const AlignabilityMap& map) {
  const TemporaryFolder folder;
  write_alignability_map(map, folder / "map");
  return read_alignability_map(folder / "map.yaml");
}

void expect_same_bits(const Grid<float>& a, const Grid<float>& b) {
  ASSERT_EQ(a.values().size(), b.values().size());
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    EXPECT_TRUE(std::bit_cast<std::uint32_t>(a[i]) == std::bit_cast<std::uint32_t>(b[i]) || (std::isnan(a[i]) && std::isnan(b[i])))
        << a[i] << ' ' << b[i];
  }
}

void expect_same(const AlignabilityMap& a, const AlignabilityMap& b) {
  EXPECT_EQ(a.geometry, b.geometry);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.options, b.options);
  EXPECT_EQ(a.sensor, b.sensor);
  EXPECT_EQ(a.provenance, b.provenance);
  EXPECT_EQ(a.error_model, b.error_model);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].name, b.layers[i].name);
    EXPECT_EQ(a.layers[i].values.geometry(), b.layers[i].values.geometry());
    expect_same_bits(a.layers[i].values, b.layers[i].values);
  }
}

TEST(AlignabilityMapFile, ReadsBackAsItWasWritten) { expect_same(again(small_map()), small_map()); }

TEST(AlignabilityMapFile, FindsLayersByName) {
  const AlignabilityMap map = again(small_map());
  ASSERT_NE(map.find_layer("weak_x"), nullptr);
  EXPECT_EQ((*map.find_layer("weak_x"))[std::size_t{0}], -1.0f);
  EXPECT_EQ(map.find_layer("alpha"), &map.alpha());
  EXPECT_EQ(map.find_layer("weak"), nullptr);
}

TEST(AlignabilityMapFile, SaysWhatItHoldsInPlainYaml) {
  const TemporaryFolder folder;
  write_alignability_map(small_map(), folder / "hall");
  const std::string yaml = read_file(folder / "hall.yaml", 10000);
  EXPECT_THAT(yaml, HasSubstr("image: hall.tiff\n"));
  EXPECT_THAT(yaml, HasSubstr("resolution: 0.1\n"));
  EXPECT_THAT(yaml, HasSubstr("origin: [-15.1, 0.30000000000000004]\n"));
  EXPECT_THAT(yaml, HasSubstr("size: [3, 2]\n"));
  EXPECT_THAT(yaml, HasSubstr("layers: [alpha, weak_x]\n"));
  EXPECT_THAT(yaml, HasSubstr("seed: 7\n"));
  EXPECT_THAT(yaml, HasSubstr("  name: Velodyne HDL-32E\n"));
  EXPECT_EQ(folder.files(), 2);
}

TEST(AlignabilityMapFile, IsTheSameToTheByteEachTime) {
  const TemporaryFolder folder;
  write_alignability_map(small_map(), folder / "a");
  const std::string first = read_file(folder / "a.tiff", 1 << 20);
  write_alignability_map(small_map(), folder / "a");
  EXPECT_EQ(read_file(folder / "a.tiff", 1 << 20), first);
}

TEST(AlignabilityMapFile, HasTheTopRowFirstAndTheNamesOfItsPages) {
  const TemporaryFolder folder;
  write_alignability_map(small_map(), folder / "a");
  TIFFSetWarningHandler(nullptr);  // it does not know GDAL_NODATA
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen((folder / "a.tiff").c_str(), "r"), TIFFClose);
  ASSERT_NE(tiff, nullptr);
  std::vector<float> row(3);
  ASSERT_EQ(TIFFReadScanline(tiff.get(), row.data(), 0), 1);
  EXPECT_TRUE(std::isnan(row[0]));
  EXPECT_EQ(row[1], 0.5f);
  const char* name = nullptr;
  ASSERT_EQ(TIFFGetField(tiff.get(), TIFFTAG_PAGENAME, &name), 1);
  EXPECT_STREQ(name, "alpha");
  ASSERT_EQ(TIFFReadDirectory(tiff.get()), 1);
  ASSERT_EQ(TIFFGetField(tiff.get(), TIFFTAG_PAGENAME, &name), 1);
  EXPECT_STREQ(name, "weak_x");
  EXPECT_EQ(TIFFReadDirectory(tiff.get()), 0);
}

TEST(AlignabilityMapFile, ReadsBackRandomMaps) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-1e4, 1e4);
    std::uniform_real_distribution<float> alpha;
    AlignabilityMap map;
    map.geometry = {.resolution = std::abs(place(random)),
                    .origin = {place(random), place(random)},
                    .width = 1 + static_cast<int>(random() % 300),
                    .height = 1 + static_cast<int>(random() % 300)};
    for (std::uint64_t k = 0; k < 1 + random() % 9; ++k) {
      Grid<float> values(map.geometry, kNone);
      for (std::size_t i = 0; i < map.geometry.size(); ++i) values[i] = random() % 5 == 0 ? kNone : alpha(random);
      map.layers.push_back({k == 0 ? "alpha" : "layer: " + std::to_string(k), std::move(values)});
    }
    map.seed = random() >> 1;
    expect_same(again(map), map);
  }
}

TEST(AlignabilityMapFile, ReadsBackMapsOfOneRowColumnOrCell) {
  constexpr std::pair<int, int> kSizes[] = {{1, 1}, {1, 7}, {7, 1}};
  for (const auto& [width, height] : kSizes) {
    AlignabilityMap map;
    map.geometry = {.resolution = 1.0, .width = width, .height = height};
    Grid<float> values(map.geometry, kNone);
    for (std::size_t i = 0; i < map.geometry.size(); i += 2) values[i] = 0.125f * static_cast<float>(i);
    map.layers = {{"alpha", values}, {"iqr", Grid<float>(map.geometry, kNone)}};
    expect_same(again(map), map);
  }
}

TEST(AlignabilityMapFile, KeepsAnySeed) {
  AlignabilityMap map = small_map();
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1} << 63, std::numeric_limits<std::uint64_t>::max()}) {
    map.seed = seed;
    EXPECT_EQ(again(map).seed, seed);
  }
}

TEST(AlignabilityMapFile, ShrinksAnEmptyMapWithoutRefusingToReadItBack) {
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 3000, .height = 3000};
  map.layers.push_back({"alpha", Grid<float>(map.geometry, kNone)});
  expect_same(again(map), map);
}

class SensorText : public ::testing::TestWithParam<const char*> {};

TEST_P(SensorText, IsKeptVerbatim) {
  AlignabilityMap map = small_map();
  map.sensor = GetParam();
  EXPECT_EQ(again(map).sensor, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Texts, SensorText,
                         ::testing::Values("name: a\n", "# a comment first\n\nname: a\n", "name: größe ±2 cm → \U0001F916\n",
                                           "a: |\n  block\n\n  in a block\nb: 1\n", "trailing: spaces   \n\n\n# end\n",
                                           "quotes: \"it's\"\n", "---\na: 1\n", "tab:\there\n", "%: 1\nb: - ? : #\n",
                                           "  indented: first\nnot: then\n", "\nempty: line first\n", "\ttab: first\n", " \nspace: first\n",
                                           "windows: 1\r\nlines: 2\r\n", "no: line break", "two: breaks\n\n", "    deep: 1\n    er: 2\n",
                                           "ends: with\n  \n", "bell: \a\n"));

TEST(AlignabilityMapFile, LeavesOutTextsThatAreEmpty) {
  AlignabilityMap map = small_map();
  map.sensor = map.options = map.provenance = "";
  expect_same(again(map), map);
}

TEST(AlignabilityMapFile, ReadsWhatOtherProgramsWrite) {
  const TemporaryFolder folder;
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    write_tiff(folder / "a.tif", {{.width = 5, .height = 4, .compression = compression},
                                  {.width = 5, .height = 4, .compression = compression, .value = 7.0f}});
    const auto file = folder.write("a.yaml", "image: a.tif\nresolution: 1\norigin: [0, 0]\nsize: [5, 4]\nlayers: [alpha, samples]\n");
    const AlignabilityMap map = read_alignability_map(file);
    EXPECT_THAT(map.alpha().values(), ::testing::Each(0.5f));
    EXPECT_THAT(map.find_layer("samples")->values(), ::testing::Each(7.0f));
    EXPECT_EQ(map.seed, 0u);
  }
}

}  // namespace
}  // namespace alignability
