// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "tests/lidar/fixtures.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::TemporaryFolder;
using testing::HasSubstr;

template <typename T>
std::string bytes_of(std::initializer_list<T> values, std::endian order = std::endian::little) {
  std::string bytes;
  for (const T value : values) {
    std::string word(reinterpret_cast<const char*>(&value), sizeof(T));
    if (order != std::endian::native) word.assign(word.rbegin(), word.rend());
    bytes += word;
  }
  return bytes;
}

std::string pcd_header(const std::string& data, int points, int height = 1) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         std::to_string(points / height) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(points) + "\nDATA " + data + "\n";
}

std::string ply_header(const std::string& format, const std::string& vertices, const std::string& properties) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices + "\n" + properties + "end_header\n";
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

constexpr const char* kFloats = "property float x\nproperty float y\nproperty float z\n";

TEST(ScanFile, WhatIsWrittenReadsBackToTheBit) {
  const TemporaryFolder folder;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Scan scan{.points = {{1, 2, 3}, {kNan, kNan, kNan}, {0.1f, -0.2f, 1e-30f}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}}, .rings = 2, .columns = 3};
  write_pcd(scan, folder / "scan.pcd");
  const Scan read = read_scan_file(folder / "scan.pcd");
  EXPECT_EQ(read.rings, 2);
  EXPECT_EQ(read.columns, 3);
  ASSERT_EQ(read.points.size(), 6u);
  EXPECT_TRUE(read.points[1].array().isNaN().all());
  for (const std::size_t i : {0u, 2u, 3u, 4u, 5u}) EXPECT_EQ(read.points[i], scan.points[i]);
}

TEST(ScanFile, WritesWholeOrNotAtAll) {
  EXPECT_THAT(fault_of([] { write_pcd({}, "/nowhere/at/all.pcd"); }), HasSubstr("cannot be written"));
}

TEST(ScanFile, ReadsAsciiPcd) {
  const TemporaryFolder folder;
  const Scan scan = read_scan_file(folder.write("a.pcd", pcd_header("ascii", 3) + "1 2 3\r\n\n nan nan nan \n+4 5e-1 -inf"));
  ASSERT_EQ(scan.points.size(), 3u);
  EXPECT_FALSE(scan.organized());
  EXPECT_EQ(scan.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_TRUE(scan.points[1].array().isNaN().all());
  EXPECT_TRUE(scan.points[2].array().isNaN().all());
}

TEST(ScanFile, FindsCoordinatesAmongOtherFields) {
  const TemporaryFolder folder;
  const std::string header =
      "VERSION .7\nFIELDS intensity z _ y x\nSIZE 1 8 1 4 4\nTYPE U F U F F\nCOUNT 1 1 3 1 1\nWIDTH 1\nHEIGHT 2\nPOINTS 2\nDATA binary\n";
  const std::string row = "i" + bytes_of({3.0}) + "___" + bytes_of({2.0f, 1.0f});
  const Scan scan = read_scan_file(folder.write("a.pcd", header + row + row));
  EXPECT_EQ(scan.rings, 2);
  EXPECT_EQ(scan.points[1], Eigen::Vector3f(1, 2, 3));
}

TEST(ScanFile, ReadsCompressedPcd) {
  const TemporaryFolder folder;
  // Columns x x y y z z of (1, 2, 3) twice: literals, then a copy of what lies 4 bytes back.
  const auto pair = [](float value) { return "\x03" + bytes_of({value}) + "\x40\x03"; };
  const std::string packed = pair(1) + pair(2) + pair(3);
  const std::string sizes = bytes_of({static_cast<std::uint32_t>(packed.size()), 24u});
  const Scan scan = read_scan_file(folder.write("a.pcd", pcd_header("binary_compressed", 2) + sizes + packed));
  EXPECT_EQ(scan.points, (std::vector<Eigen::Vector3f>{{1, 2, 3}, {1, 2, 3}}));
}

TEST(ScanFile, ReadsPlyOfEveryFormat) {
  const TemporaryFolder folder;
  const std::string properties = "property uchar ring\nproperty double x\nproperty float32 y\nproperty float z\n";
  const std::vector<Eigen::Vector3f> expected{{1, 2, 3}};
  const auto faces = "element face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(read_scan_file(folder.write("a.ply", ply_header("ascii", "1", properties + faces) + "7 1 2 3\n3 0 0 0\n")).points, expected);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    const std::string row = "r" + bytes_of({1.0}, order) + bytes_of({2.0f, 3.0f}, order);
    EXPECT_EQ(read_scan_file(folder.write("a.ply", ply_header(format, "1", properties) + row)).points, expected);
  }
}

TEST(ScanFile, ReadsKittisPoints) {
  const TemporaryFolder folder;
  const std::string bytes = bytes_of({1.0f, -2.0f, 3.0f, 0.5f}) + bytes_of({std::nanf(""), 0.0f, 0.0f, 0.0f});
  const Scan scan = read_scan_file(folder.write("000000.BIN", bytes));
  ASSERT_EQ(scan.points.size(), 2u);
  EXPECT_EQ(scan.columns, 2);
  EXPECT_EQ(scan.points[0], Eigen::Vector3f(1, -2, 3));
  EXPECT_TRUE(scan.points[1].array().isNaN().all());
}

// PCL leaves its padding out of compressed files, whose header names it all the same.
TEST(ScanFile, ReadsCompressedPcdWithPaddingAndDoubles) {
  const TemporaryFolder folder;
  const std::string header =
      "VERSION 0.7\nFIELDS x y z _\nSIZE 8 8 8 1\nTYPE F F F U\nCOUNT 1 1 1 4\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary_compressed\n";
  const std::string packed = std::string("\x17") + bytes_of({1.5, -2.0, 3.0});
  const Scan scan = read_scan_file(folder.write("f", header + bytes_of({25u, 24u}) + packed));
  ASSERT_EQ(scan.points.size(), 1u);
  EXPECT_EQ(scan.points[0], Eigen::Vector3f(1.5f, -2.0f, 3.0f));
}

TEST(ScanFile, TakesNumbersBeyondAFloatForNoReturn) {
  const TemporaryFolder folder;
  const Scan scan = read_scan_file(folder.write("f", pcd_header("ascii", 2) + "1e999 2 3\n+4 5 6\n"));
  EXPECT_TRUE(scan.points[0].array().isNaN().all());
  EXPECT_EQ(scan.points[1], Eigen::Vector3f(4.0f, 5.0f, 6.0f));
}

TEST(ScanFile, RefusesBinFilesThatHoldNoPoints) {
  const TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) { return fault_of([&] { read_scan_file(folder.write("f.bin", bytes)); }); };
  const std::string good = bytes_of({1.0f, 2.0f, 3.0f, 0.5f, 4.1f, 5.2f, 6.3f, 0.5f});
  EXPECT_EQ(fault(good), "");
  EXPECT_EQ(fault(""), "f.bin: holds no points");
  EXPECT_EQ(fault(good.substr(0, 31)),
            "f.bin: is 31 bytes long; x, y, z and intensity of a point take 16, so it is cut short or no Velodyne file");
  const std::string nowhere = ", counted from 0, lies where no lidar measures: these are no little-endian floats";
  EXPECT_EQ(fault(bytes_of({1.0f, 2.0f, 3.0f, 0.5f}, std::endian::big)), "f.bin: point 0" + nowhere);
  EXPECT_EQ(fault(good + std::string("a text of sixty-four bytes, say, that is of a length to be points")).substr(0, 14), "f.bin: is 97 b");
  EXPECT_EQ(fault(good + "sixteen letters!"), "f.bin: point 2" + nowhere);
  EXPECT_EQ(fault(bytes_of({1.0f, 2e7f, 3.0f, 0.5f})), "f.bin: point 0" + nowhere);
}

TEST(ScanFile, ReadsTheNormalsThatPointsComeWith) {
  const TemporaryFolder folder;
  const std::vector<Eigen::Vector3f> points{{1, 2, 3}}, normals{{0, 0, 1}};
  const std::string pcd =
      "VERSION .7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\nCOUNT 1 1 1 1 1 1\n"
      "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ";
  const std::string packed = "\x17" + bytes_of({1.0f, 2.0f, 3.0f, 0.0f, 0.0f, 1.0f});
  const std::string sizes = bytes_of({static_cast<std::uint32_t>(packed.size()), 24u});
  const std::string properties = std::string(kFloats) + "property float nx\nproperty float ny\nproperty float nz\n";
  for (const std::string& bytes : {pcd + "ascii\n1 2 3 0 0 1\n", pcd + "binary\n" + bytes_of({1.0f, 2.0f, 3.0f, 0.0f, 0.0f, 1.0f}),
                                   pcd + "binary_compressed\n" + sizes + packed, ply_header("ascii", "1", properties) + "1 2 3 0 0 1\n"}) {
    const PointCloud cloud = read_cloud_file(folder.write("f", bytes));
    EXPECT_EQ(cloud.points, points);
    EXPECT_EQ(cloud.normals, normals);
  }
  EXPECT_TRUE(read_cloud_file(folder.write("f", pcd_header("ascii", 1) + "1 2 3\n")).normals.empty());
}

struct Malformed {
  const char* what;
  std::string bytes;
  const char* message;
};

class MalformedScanFile : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScanFile, IsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_of([&] { read_scan_file(folder.write("f", GetParam().bytes)); }), GetParam().message);
}

std::string with(std::string text, const std::string& replaced, const std::string& by) {
  return text.replace(text.find(replaced), replaced.size(), by);
}

const std::string kTwoPoints = pcd_header("binary", 2) + std::string(24, '\0');
const std::string kPacked = pcd_header("binary_compressed", 2);

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedScanFile,
    testing::Values(
        Malformed{"Empty", "", "f: is neither a PCD nor a PLY file, nor has it the extension .bin"},
        Malformed{"Text", "hello world\n", "f: is neither a PCD nor a PLY file, nor has it the extension .bin"},
        Malformed{"OnlyComments", "# a\n# b", "f: is neither a PCD nor a PLY file, nor has it the extension .bin"},
        Malformed{"EndsInHeader", "VERSION 0.7\nFIELDS x y z\n", "f:3: ends within the header"},
        Malformed{"EndlessLine", "VERSION " + std::string(70000, 'x'), "f:1: has no end of line in 65536 bytes"},
        Malformed{"PromisesFiveGigabytes", pcd_header("binary", 60000000),
                  "f: ends early: 60000000 points of 12 bytes are declared, 0 bytes are there"},
        Malformed{"PromisesMoreThanAllowed", with(kTwoPoints, "WIDTH 2", "WIDTH 4294967296"),
                  "f:7: '4294967296' must be a whole number from 0 to 67108864"},
        Malformed{"NegativeWidth", with(kTwoPoints, "WIDTH 2", "WIDTH -2"), "f:7: '-2' must be a whole number from 0 to 67108864"},
        Malformed{"ProductDisagrees", with(kTwoPoints, "HEIGHT 1", "HEIGHT 3"), "f:11: POINTS is not WIDTH times HEIGHT"},
        Malformed{"ProductOverflows", with(with(kTwoPoints, "WIDTH 2", "WIDTH 67108864"), "HEIGHT 1", "HEIGHT 67108864"),
                  "f:11: POINTS is not WIDTH times HEIGHT"},
        Malformed{"NoPoints", pcd_header("binary", 0), "f:11: holds no points"},
        Malformed{"NoZ", with(kTwoPoints, "x y z", "x y w"), "f: has no fields x, y and z"},
        Malformed{"XTwice", with(kTwoPoints, "x y z", "x x z"), "f: field 'x' is given twice"},
        Malformed{"IntegerX", with(kTwoPoints, "TYPE F", "TYPE I"), "f: field 'x' must be one F of size 4 or 8"},
        Malformed{"UnknownType", with(kTwoPoints, "TYPE F", "TYPE Q"), "f:5: a type is I, U or F, not 'Q'"},
        Malformed{"TooFewSizes", with(kTwoPoints, "SIZE 4 4 4", "SIZE 4 4"), "f:4: 'SIZE' must have 3 values, as 'FIELDS' before it"},
        Malformed{"SizeOfAMegabyte", with(kTwoPoints, "SIZE 4", "SIZE 1000000"), "f:4: '1000000' must be a whole number from 1 to 8"},
        Malformed{"HugeCount", with(with(kTwoPoints, "x y z", "x y z q"), "COUNT 1 1 1", "COUNT 1 1 1 65536"),
                  "f:4: 'SIZE' must have 4 values, as 'FIELDS' before it"},
        Malformed{"SizeBeforeFields", "VERSION 0.7\nSIZE 4 4 4\n", "f:2: 'SIZE' stands before 'FIELDS'"},
        Malformed{"EntryTwice", with(kTwoPoints, "HEIGHT 1", "WIDTH 2"), "f:8: 'WIDTH' is given twice"},
        Malformed{"UnknownEntry", with(kTwoPoints, "HEIGHT 1", "HIGHT 1"),
                  "f:8: 'HIGHT' is no entry of a PCD header (did you mean 'HEIGHT'?)"},
        Malformed{"UnknownData", pcd_header("zip", 2), "f:11: 'DATA' is ascii, binary or binary_compressed, not 'zip'"},
        Malformed{"BinaryCutShort", kTwoPoints.substr(0, kTwoPoints.size() - 1),
                  "f: ends early: 2 points of 12 bytes are declared, 23 bytes are there"},
        Malformed{"AsciiCutShort", pcd_header("ascii", 2) + "1 2 3\n", "f: ends early: 2 points are declared, 1 are there"},
        Malformed{"AsciiTooLong", pcd_header("ascii", 1) + "1 2 3\n4 5 6\n", "f:13: more points than declared"},
        Malformed{"AsciiTwoValues", pcd_header("ascii", 1) + "1 2\n", "f:12: expected 3 values, not 2"},
        Malformed{"AsciiWord", pcd_header("ascii", 1) + "1 2 three\n", "f:12: 'three' is not a number"},
        Malformed{"PackedWithoutSizes", kPacked + "abc", "f: ends before the compressed points"},
        Malformed{"PackedCutShort", kPacked + bytes_of({100u, 24u}) + "abc", "f: ends early: 100 bytes of compressed points are declared"},
        Malformed{"PackedOfWrongSize", kPacked + bytes_of({3u, 99u}) + "abc",
                  "f: the size of its compressed points does not fit the header"},
        Malformed{"PackedBeyondLzf", pcd_header("binary_compressed", 60000000) + bytes_of({3u, 720000000u}) + "abc",
                  "f: the size of its compressed points does not fit the header"},
        Malformed{"PackedPointsBack", kPacked + bytes_of({2u, 24u}) + "\x40\x09", "f: the compressed points cannot be unpacked"},
        Malformed{"PackedEndsInARun", kPacked + bytes_of({2u, 24u}) + "\x1f\x09", "f: the compressed points cannot be unpacked"},
        Malformed{"PackedEndsInACopy", kPacked + bytes_of({1u, 24u}) + "\xe0", "f: the compressed points cannot be unpacked"},
        Malformed{"NoFields", with(kTwoPoints, "FIELDS x y z", "FIELDS"), "f:3: 'FIELDS' must name from 1 to 1024 fields"},
        Malformed{"TooManyFields", "VERSION 0.7\nFIELDS" + repeated(" a", 1025) + "\n", "f:2: 'FIELDS' must name from 1 to 1024 fields"},
        Malformed{"SeveralZ", with(kTwoPoints, "COUNT 1 1 1", "COUNT 1 1 3"), "f: field 'z' must be one F of size 4 or 8"},
        Malformed{"TooManyBytes",
                  "VERSION 0.7\nFIELDS x y z q\nSIZE 4 4 4 8\nTYPE F F F F\nCOUNT 1 1 1 65536\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n",
                  "f: a point has more than 65536 bytes"},
        Malformed{"TwoBytesAFloat", with(kTwoPoints, "SIZE 4", "SIZE 2"), "f: field 'x' must be one F of size 4 or 8"},
        Malformed{"PackedRunBeyondTheSize", kPacked + bytes_of({33u, 24u}) + '\x1f' + std::string(32, 'a'),
                  "f: the compressed points cannot be unpacked"},
        Malformed{"PackedCopyBeyondTheSize", kPacked + bytes_of({5u, 24u}) + std::string("\0a\xe0\xff\0", 5),
                  "f: the compressed points cannot be unpacked"},
        Malformed{"PackedTooLittle", kPacked + bytes_of({2u, 24u}) + std::string("\0a", 2), "f: the compressed points cannot be unpacked"},
        Malformed{"PlyWithoutFormat", with(ply_header("ascii", "1", kFloats), "format ascii 1.0", "comment none"),
                  "f:8: the header has no 'format'"},
        Malformed{"PlyUnknownFormat", ply_header("base64", "1", kFloats), "f:2: 'base64' is no format of a PLY file"},
        Malformed{"PlyPromisesMuch", ply_header("binary_little_endian", "60000000", kFloats),
                  "f: ends early: 60000000 points of 12 bytes are declared, 0 bytes are there"},
        Malformed{"PlyPromisesTooMuch", ply_header("ascii", "99999999999", kFloats),
                  "f:4: '99999999999' must be a whole number from 0 to 67108864"},
        Malformed{"PlyNegative", ply_header("ascii", "-1", kFloats), "f:4: '-1' must be a whole number from 0 to 67108864"},
        Malformed{"PlyNoPoints", ply_header("ascii", "0", kFloats), "f:8: holds no points"},
        Malformed{"PlyWithoutZ", ply_header("ascii", "1", "property float x\nproperty float y\n"),
                  "f:7: the header has no element 'vertex' with properties x, y and z"},
        Malformed{"PlyIntegers", ply_header("ascii", "1", "property int x\n"), "f:5: 'x' must be a float or a double"},
        Malformed{"PlyUnknownType", ply_header("ascii", "1", "property half x\n"), "f:5: 'half' is no type of a PLY file"},
        Malformed{"PlyListInVertex", ply_header("ascii", "1", "property list uchar int x\n"), "f:5: a vertex with a list is not supported"},
        Malformed{"PlyFacesFirst", with(ply_header("ascii", "1", kFloats), "element vertex 1", "element face 1\nelement vertex 1"),
                  "f:4: 'vertex' must be the first element"},
        Malformed{"PlyPropertyFirst", "ply\nproperty float x\n", "f:2: a property before any element"},
        Malformed{"PlyEmptyLine", ply_header("ascii", "0", "\nobj_info by hand\n" + std::string(kFloats)), "f:10: holds no points"},
        Malformed{"PlyFormatTwice", with(ply_header("ascii", "1", kFloats), "element vertex", "format ascii 1.0\nelement vertex"),
                  "f:4: 'format' is given twice"},
        Malformed{"PlyVertexTwice", ply_header("ascii", "1", "property float x\nelement vertex 1\n"),
                  "f:6: 'vertex' must be the first element, and the only one of its name"},
        Malformed{"PlyXTwice", ply_header("ascii", "1", "property float x\nproperty float x\n"), "f:6: 'x' is given twice"},
        Malformed{"PlyTooManyBytes", ply_header("ascii", "1", repeated("property double q\n", 8193)),
                  "f:8197: a vertex has more than 65536 bytes"},
        Malformed{"PlyCountWithLetters", ply_header("ascii", "1a", kFloats), "f:4: '1a' must be a whole number from 0 to 67108864"},
        Malformed{"PlyUnknownLine", ply_header("ascii", "1", "proprety float x\n"),
                  "f:5: 'proprety' is no keyword of a PLY header (did you mean 'property'?)"},
        Malformed{"PlyEndsInHeader", "ply\nformat ascii 1.0\n", "f:3: ends within the header"}),
    [](const auto& instance) { return instance.param.what; });

TEST(ScanFile, DamagedFilesAreReadOrRefusedButNeverCrash) {
  const TemporaryFolder folder;
  const std::string packed = "\x03" + bytes_of({1.0f}) + "\x40\x03\x03" + bytes_of({2.0f}) + "\x40\x03\x03" + bytes_of({3.0f}) + "\x40\x03";
  const std::vector<std::string> seeds{kTwoPoints, kPacked + bytes_of({21u, 24u}) + packed, pcd_header("ascii", 2) + "1 2 3\n4 5 6\n",
                                       ply_header("ascii", "2", kFloats) + "1 2 3\n4 5 6\n",
                                       ply_header("binary_big_endian", "2", kFloats) + std::string(24, 'a')};
  std::mt19937_64 engine(11);
  for (const std::string& seed : seeds) {
    for (int round = 0; round < 400; ++round) {
      std::string bytes = seed;
      for (int i = 0; i < 3; ++i) bytes[engine() % bytes.size()] = static_cast<char>(engine());
      bytes.resize(bytes.size() - (round % 4 == 0 ? engine() % bytes.size() : 0));
      fault_of([&] { read_scan_file(folder.write("f", bytes)); });
    }
  }
}

struct Known {
  const char* file;
  std::size_t points;
};

class RealScan : public testing::TestWithParam<Known> {};

TEST_P(RealScan, IsReadWhole) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, GetParam().file);
  const Scan scan = read_scan_file(file);
  EXPECT_EQ(scan.points.size(), GetParam().points);
  for (const Eigen::Vector3f& point : scan.points) {
    ASSERT_TRUE(point.allFinite());
    ASSERT_LT(point.norm(), 260.0f);
  }
}

INSTANTIATE_TEST_SUITE_P(SharedData, RealScan,
                         testing::Values(Known{"scans/room/room_scan1.pcd", 112586}, Known{"scans/hdl32-pair/251370668.pcd", 69088},
                                         Known{"scans/hdl32-street/hdl32_rev1.pcd", 53303}, Known{"clouds/ouster-street.ply", 155000},
                                         Known{"clouds/outdoor-features.pcd", 62445}, Known{"logs/simulated-hall/scans/001.pcd", 28800},
                                         Known{"logs/real-hall/scans/full000.pcd", 73452}));

}  // namespace
}  // namespace alignability
