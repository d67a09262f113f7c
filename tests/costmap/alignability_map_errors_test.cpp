// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>
#include <random>

#include "core/file.hpp"
#include "costmap/alignability_map.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/tiff_files.hpp"

namespace alignability {
namespace {

using test::TemporaryFolder;
using test::thrown_message;
using test::TiffPage;
using test::write_tiff;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kGood = "image: a.tiff\nresolution: 0.5\norigin: [-1, 2]\nsize: [3, 2]\nlayers: [alpha]\nseed: 1\n";

std::string with(const std::string& line, const std::string& instead) {
  std::string text = kGood;
  return text.replace(text.find(line), line.size(), instead);
}

struct YamlFault {
  std::string yaml;
  std::string message;  // after the file's name
};

class AlignabilityMapRefusesYaml : public ::testing::TestWithParam<YamlFault> {};

TEST_P(AlignabilityMapRefusesYaml, AtTheLineAndColumn) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tiff", {{.width = 3, .height = 2}});
  const auto file = folder.write("a.yaml", GetParam().yaml);
  EXPECT_EQ(thrown_message([&] { read_alignability_map(file); }), file.string() + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, AlignabilityMapRefusesYaml,
    ::testing::Values(YamlFault{with("image: a.tiff\n", ""), ":1:1: missing key 'image'"},
                      YamlFault{with("resolution: 0.5\n", ""), ":1:1: missing key 'resolution'"},
                      YamlFault{with("origin: [-1, 2]\n", ""), ":1:1: missing key 'origin'"},
                      YamlFault{with("size: [3, 2]\n", ""), ":1:1: missing key 'size'"},
                      YamlFault{with("layers: [alpha]\n", ""), ":1:1: missing key 'layers'"},
                      YamlFault{with("layers", "layres"), ":5:1: unknown key 'layres' (did you mean 'layers'?)"},
                      YamlFault{with("[alpha]", "[]"), ":5:9: 'layers' must be a list whose first name is 'alpha'"},
                      YamlFault{with("[alpha]", "[samples, alpha]"), ":5:9: 'layers' must be a list whose first name is 'alpha'"},
                      YamlFault{with("[alpha]", "[alpha, iqr, iqr]"), ":5:9: 'layers' names 'iqr' twice"},
                      YamlFault{with("[alpha]", "alpha"), ":5:9: 'layers' must be a list of words"},
                      YamlFault{with("0.5", "-0.5"), ":2:13: 'resolution' must be greater than 0, not -0.5"},
                      YamlFault{with("[-1, 2]", "[-1, 2, 0]"), ":3:9: 'origin' must be a list of 2 numbers, not 3"},
                      YamlFault{with("[-1, 2]", "[-1, .nan]"), ":3:14: 'origin' must be a finite number, not .nan"},
                      YamlFault{with("[3, 2]", "[3, 2.5]"), ":4:7: 'size' must be whole numbers of cells"},
                      YamlFault{with("[3, 2]", "[0, 2]"), ":4:8: 'size' must be from 1 to 1048576, not 0"},
                      YamlFault{with("[3, 2]", "[3, -2]"), ":4:11: 'size' must be from 1 to 1048576, not -2"},
                      YamlFault{with("[3, 2]", "[3, 1048577]"), ":4:11: 'size' must be from 1 to 1048576, not 1048577"},
                      YamlFault{with("seed: 1", "seed: -1"), ":6:7: 'seed' must be a whole number from 0 to 18446744073709551615, not -1"},
                      YamlFault{with("seed: 1", "seed: 1.5"),
                                ":6:7: 'seed' must be a whole number from 0 to 18446744073709551615, not 1.5"},
                      YamlFault{kGood + "sede: 2\n", ":7:1: unknown key 'sede' (did you mean 'seed'?)"},
                      YamlFault{kGood + "sensor: {name: x}\n", ":7:9: 'sensor' must be a word"},
                      YamlFault{kGood + "error_model: {growth: 0.02, recovery: 3, least: 0.01, alpha_poor: 0.4, alpha_rich: 0.4}\n",
                                ":7:67: 'alpha_poor' must be less than 'alpha_rich'"}));

struct TiffFault {
  std::vector<TiffPage> pages;
  std::string message;
};

class AlignabilityMapRefusesTiff : public ::testing::TestWithParam<TiffFault> {};

TEST_P(AlignabilityMapRefusesTiff, NamingTheTiff) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tiff", GetParam().pages);
  EXPECT_EQ(thrown_message([&] { read_alignability_map(folder.write("a.yaml", kGood)); }),
            (folder / "a.tiff").string() + ": " + GetParam().message);
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const char* const kKind = "must hold rows of one 32-bit float a pixel";
const char* const kAlpha = "holds an alignability that is neither from 0 to 1 nor NaN";

INSTANTIATE_TEST_SUITE_P(Table, AlignabilityMapRefusesTiff,
                         ::testing::Values(TiffFault{{{.width = 2, .height = 3}}, "is 2 × 3 pixels where the map has 3 × 2 cells"},
                                           TiffFault{{{.width = 3, .height = 3}}, "is 3 × 3 pixels where the map has 3 × 2 cells"},
                                           TiffFault{{{.width = 3, .height = 2, .bits = 8, .format = SAMPLEFORMAT_UINT}}, kKind},
                                           TiffFault{{{.width = 3, .height = 2, .bits = 64}}, kKind},
                                           TiffFault{{{.width = 3, .height = 2, .format = SAMPLEFORMAT_INT}}, kKind},
                                           TiffFault{{{.width = 3, .height = 2, .samples = 3}}, kKind},
                                           TiffFault{{{.width = 3, .height = 2, .tiled = true}}, kKind},
                                           TiffFault{{{.width = 3, .height = 2}, {.width = 3, .height = 2}},
                                                     "has more pages than the map has layers, 1"},
                                           TiffFault{{{.width = 3, .height = 2, .value = 1.5f}}, kAlpha},
                                           TiffFault{{{.width = 3, .height = 2, .value = -0.1f}}, kAlpha},
                                           TiffFault{{{.width = 3, .height = 2, .value = kInfinity}}, kAlpha}));

TEST(AlignabilityMapErrors, ATiffThatIsMissingOrNoneIsNamed) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.yaml", kGood);
  EXPECT_THAT(thrown_message([&] { read_alignability_map(file); }),
              StartsWith((folder / "a.tiff").string() + ": cannot be read: No such file"));
  const auto image = folder.write("a.tiff", "not a TIFF, but long enough");
  EXPECT_THAT(thrown_message([&] { read_alignability_map(file); }), StartsWith(image.string() + ": not a TIFF: "));
  folder.write("a.tiff", "");
  EXPECT_THAT(thrown_message([&] { read_alignability_map(file); }), StartsWith(image.string() + ": is 0 bytes long"));
  std::filesystem::remove(image);
  std::filesystem::create_directory(image);
  EXPECT_THAT(thrown_message([&] { read_alignability_map(file); }), StartsWith(image.string() + ": "));
}

TEST(AlignabilityMapErrors, FewerPagesThanLayersAreRefused) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tiff", {{.width = 3, .height = 2}, {.width = 3, .height = 2}});
  EXPECT_EQ(thrown_message([&] { read_alignability_map(folder.write("a.yaml", with("[alpha]", "[alpha, iqr, samples]"))); }),
            (folder / "a.tiff").string() + ": has 2 pages where a.yaml names 3 layers");
}

TEST(AlignabilityMapErrors, ASizeThatTheFileCannotHoldIsRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tiff", {{.width = 3, .height = 2}});
  const auto length = std::to_string(std::filesystem::file_size(folder / "a.tiff"));
  EXPECT_EQ(thrown_message([&] { read_alignability_map(folder.write("a.yaml", with("[3, 2]", "[1048576, 1048576]"))); }),
            (folder / "a.tiff").string() + ": is " + length + " bytes long, which cannot hold 1099511627776 cells");
}

TEST(AlignabilityMapErrors, ACutTiffIsRefusedUnlessNothingIsLost) {
  const TemporaryFolder folder;
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 20, .height = 20};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> alpha;
  Grid<float> values(map.geometry, 0.0f);
  for (std::size_t i = 0; i < map.geometry.size(); ++i) values[i] = alpha(random);
  map.layers = {{"alpha", values}, {"iqr", values}};
  write_alignability_map(map, folder / "a");
  const std::string whole = read_file(folder / "a.tiff", 1 << 20);
  for (std::size_t length = 0; length < whole.size(); length += 5) {
    folder.write("a.tiff", whole.substr(0, length));
    try {
      const AlignabilityMap read = read_alignability_map(folder / "a.yaml");
      EXPECT_GT(length + 16, whole.size()) << "only the tail of the last directory can be spared";
      for (const AlignabilityMap::Layer& layer : read.layers) EXPECT_EQ(layer.values.values(), values.values());
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.tiff: "));
    }
  }
}

TEST(AlignabilityMapErrors, DamageAnywhereIsAnInputErrorOrAMap) {
  const TemporaryFolder folder;
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 7, .height = 5};
  map.layers = {{"alpha", Grid<float>(map.geometry, 0.25f)}, {"iqr", Grid<float>(map.geometry, 0.5f)}};
  write_alignability_map(map, folder / "a");
  const std::string whole = read_file(folder / "a.tiff", 1 << 20);
  constexpr std::uint64_t kSeed = 43;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    for (std::uint64_t k = 0; k <= random() % 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    folder.write("a.tiff", bytes);
    try {
      read_alignability_map(folder / "a.yaml");
    } catch (const InputError&) {
    }
  }
}

TEST(AlignabilityMapErrors, AFolderThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .width = 1, .height = 1};
  map.layers = {{"alpha", Grid<float>(map.geometry, 0.25f)}};
  EXPECT_EQ(thrown_message([&] { write_alignability_map(map, folder / "no" / "map"); }),
            (folder / "no" / "map.tiff").string() + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace alignability
