// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "core/file.hpp"
#include "costmap/map_server.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/costmap/images.hpp"

namespace alignability {
namespace {

using test::pgm;
using test::TemporaryFolder;
using test::thrown_message;
using ::testing::StartsWith;

const std::string kGood = "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string with(const std::string& line, const std::string& instead) {
  std::string text = kGood;
  return text.replace(text.find(line), line.size(), instead);
}

struct YamlFault {
  std::string yaml;
  std::string message;  // after the folder
};

class MapServerRefusesYaml : public ::testing::TestWithParam<YamlFault> {};

TEST_P(MapServerRefusesYaml, AtTheLineAndColumn) {
  const TemporaryFolder folder;
  folder.write("map.pgm", pgm(2, {0, 254}));
  const auto file = folder.write("map.yaml", GetParam().yaml);
  EXPECT_EQ(thrown_message([&] { read_occupancy_map(file); }), file.string() + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, MapServerRefusesYaml,
    ::testing::Values(YamlFault{with("image: map.pgm\n", ""), ":1:1: missing key 'image'"},
                      YamlFault{with("resolution: 0.05\n", ""), ":1:1: missing key 'resolution'"},
                      YamlFault{with("origin: [0, 0, 0]\n", ""), ":1:1: missing key 'origin'"},
                      YamlFault{with("negate: 0\n", ""), ":1:1: missing key 'negate': 0 where white is free, 1 where black is"},
                      YamlFault{with("occupied_thresh: 0.65\n", ""), ":1:1: missing key 'occupied_thresh'"},
                      YamlFault{with("free_thresh: 0.196\n", ""), ":1:1: missing key 'free_thresh'"},
                      YamlFault{with("resolution", "resoluton"), ":2:1: unknown key 'resoluton' (did you mean 'resolution'?)"},
                      YamlFault{with("free_thresh", "free_tresh"), ":6:1: unknown key 'free_tresh' (did you mean 'free_thresh'?)"},
                      YamlFault{kGood + "modde: raw\n", ":7:1: unknown key 'modde' (did you mean 'mode'?)"},
                      YamlFault{kGood + "mode: Trinary\n",
                                ":7:7: 'mode' is 'Trinary', which is none of: trinary, scale, raw (did you mean 'trinary'?)"},
                      YamlFault{kGood + "resolution: 0.1\n", ":7:1: key 'resolution' is given twice"},
                      YamlFault{with("0.05", "0"), ":2:13: 'resolution' must be greater than 0, not 0"},
                      YamlFault{with("0.05", ".nan"), ":2:13: 'resolution' must be greater than 0, not .nan"},
                      YamlFault{with("[0, 0, 0]", "[0, 0]"), ":3:9: 'origin' must be a list of 3 numbers, not 2"},
                      YamlFault{with("[0, 0, 0]", "[0, .inf, 0]"), ":3:13: 'origin' must be a finite number, not .inf"},
                      YamlFault{with("[0, 0, 0]", "[0, 0, 0.1]"),
                                ":3:9: the origin's yaw is 0.1; only maps with a yaw of 0 are supported: rotate the image instead"},
                      YamlFault{with("negate: 0", "negate: 2"), ":4:9: 'negate' is '2', which is none of: 0, 1, false, true"},
                      YamlFault{with("0.65", "1.5"), ":5:18: 'occupied_thresh' must be from 0 to 1, not 1.5"},
                      YamlFault{with("0.196", "-0.1"), ":6:14: 'free_thresh' must be from 0 to 1, not -0.1"},
                      YamlFault{with("0.196", "0.65"), ":6:14: 'free_thresh' must be less than 'occupied_thresh'"}));

struct ImageFault {
  std::string bytes;
  std::string message;  // after the image's name
};

class MapServerRefusesImage : public ::testing::TestWithParam<ImageFault> {};

TEST_P(MapServerRefusesImage, AtTheLineAndColumnOfATextAndByNameAlways) {
  const TemporaryFolder folder;
  const auto image = folder.write("map.pgm", GetParam().bytes);
  EXPECT_EQ(thrown_message([&] { read_occupancy_map(folder.write("map.yaml", kGood)); }), image.string() + GetParam().message);
}

const std::string kPngHeader("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
const std::string kNeither = ": is neither a PNG nor a PGM, PPM or PBM";
const std::string kTooLarge = " pixels, more than it can hold or we read";

INSTANTIATE_TEST_SUITE_P(
    Table, MapServerRefusesImage,
    ::testing::Values(ImageFault{"", kNeither}, ImageFault{"P", kNeither}, ImageFault{"P7\n1 1\n", kNeither},
                      ImageFault{"GIF89a", kNeither}, ImageFault{std::string(1000, '\0'), kNeither}, ImageFault{"P5", kNeither},
                      ImageFault{"P5\n", ":2:1: ends early"}, ImageFault{"P5\n3", ":2:2: ends early"},
                      ImageFault{"P5\n3 3\n", ":3:1: ends early"}, ImageFault{"P5\nthree 3\n255\n123456789", ":2:1: 'three' is no number"},
                      ImageFault{"P5\n# wide\n-3 -3\n255\n123456789", ":3:1: '-3' is no number"},
                      ImageFault{"P5\n0 0\n255\n", ": has no pixels"}, ImageFault{"P5\n3 3\n255\n12345", ": ends early"},
                      ImageFault{"P5\n3 3\n255\n", ": ends early"}, ImageFault{"P2\n3 3\n255\n1 2 3 4\n", ":5:1: ends early"},
                      ImageFault{"P2\n3 1\n255\n1 two 3\n", ":4:3: 'two' is no number"},
                      ImageFault{"P2\n3 1\n255\n1 -2 3\n", ":4:3: '-2' is no number"},
                      ImageFault{"P2\n3 1\n255\n1 2,3\n", ":4:3: '2,3' is no number"},
                      ImageFault{"P2\n3 1\n255\n1 256 3\n", ":4:3: 256 is above white, 255"},
                      ImageFault{"P2\n3 1\n100\n1\n101 3\n", ":5:1: 101 is above white, 100"},
                      ImageFault{"P2\n3 1\n255\n1 99999999999999999999999 3\n", ":4:3: '99999999999999999999999' is no number"},
                      ImageFault{"P2\n3 1\n255\n1 " + std::string(100, 'x'), ":4:3: '" + std::string(40, 'x') + "' is no number"},
                      ImageFault{"P3\n1 1\n255\n1 2\n", ":5:1: ends early"}, ImageFault{"P6\n2 1\n255\n1234", ": ends early"},
                      ImageFault{"P1\n3 3\n1 0 1\n", ":4:1: ends early"}, ImageFault{"P1\n3 1\n1 2 1\n", ":3:3: a bit is neither 0 nor 1"},
                      ImageFault{"P4\n16 3\n1", ": ends early"},
                      ImageFault{"P5\n3 3\n65536\n123456789123456789", ":3:1: white must be from 1 to 65535, not 65536"},
                      ImageFault{"P5\n3 3\n0\n123456789", ":3:1: white must be from 1 to 65535, not 0"},
                      ImageFault{"P5\n3 3\n65535\n12345678912345678", ": ends early"}, ImageFault{"P5\n3 1\n255", ":3:4: ends early"},
                      ImageFault{"P5\n3 1\n100\n12\xff", ": 255 is above white, 100"},
                      ImageFault{"P5\n100000 100000\n255\n0", ": says that it is 100000 × 100000" + kTooLarge},
                      ImageFault{"P5\n4294967297 1\n255\n0", ": says that it is 4294967297 × 1" + kTooLarge},
                      ImageFault{"P5\n1 4294967297\n255\n0", ": says that it is 1 × 4294967297" + kTooLarge},
                      ImageFault{"P5\n99999999999999999999 1\n255\n0", ":2:1: '99999999999999999999' is no number"},
                      ImageFault{"P2\n100000 100000\n255\n0", ": says that it is 100000 × 100000" + kTooLarge},
                      ImageFault{"\x89PNG", ": damaged PNG: it ends early"}, ImageFault{kPngHeader, ": damaged PNG: it ends early"},
                      ImageFault{kPngHeader + std::string("\0\1\0\0\0\1\0\0\10\0\0\0\0\0\0\0\0", 17), ": damaged PNG: IHDR: CRC error"}));

TEST(MapServerErrors, AMissingImageIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(thrown_message([&] { read_occupancy_map(folder.write("map.yaml", kGood)); }), (folder / "map.pgm").string() + ": no such file");
}

TEST(MapServerErrors, ACutPngIsDamaged) {
  const TemporaryFolder folder;
  test::write_png(folder / "map.pgm", test::PngKind::grey, 100, std::vector<int>(10000, 254));
  const std::string whole = read_file(folder / "map.pgm", 1 << 20);
  for (std::size_t length = 0; length + 13 < whole.size(); length += 3) {  // what is left out at the end is more than the end's own mark
    const auto image = folder.write("map.pgm", whole.substr(0, length));
    EXPECT_THAT(thrown_message([&] { read_occupancy_map(folder.write("map.yaml", kGood)); }), StartsWith(image.string() + ": ")) << length;
  }
}

TEST(MapServerErrors, DamageAnywhereIsAnInputErrorOrAMap) {
  const TemporaryFolder folder;
  const auto file = folder.write("map.yaml", kGood);
  test::write_png(folder / "a.png", test::PngKind::rgba, 2, std::vector<int>(16, 254));
  const std::vector<std::string> images{pgm(3, {0, 1, 2, 3, 4, 5}),    "P2\n# c\n3 2\n255\n0 1 2\n3 4 5\n",
                                        "P1\n3 2\n1 0 1 0 1 0\n",      "P4\n9 1\n\x80\x80",
                                        "P3\n1 2\n255\n1 2 3 4 5 6\n", read_file(folder / "a.png", 10000)};
  constexpr std::uint64_t kSeed = 41;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = images[random() % images.size()];
    for (std::uint64_t k = 0; k <= random() % 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    folder.write("map.pgm", bytes);
    try {
      read_occupancy_map(file);
    } catch (const InputError&) {
    } catch (const std::exception& error) {
      FAIL() << "not an InputError: " << error.what() << " for " << ::testing::PrintToString(bytes);
    }
  }
}

TEST(MapServerErrors, AFolderThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(thrown_message([&] { write_occupancy_map(OccupancyMap(Grid<float>({.width = 1, .height = 1}, 0.0f)), folder / "no" / "map"); }),
            (folder / "no" / "map.pgm").string() + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace alignability
