// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability::detail {
namespace {

CellValue value_of(std::size_t cell) {
  const auto number = static_cast<float>(cell);
  return {1.0f / number, number, 0.1f * number, number, std::nanf(""), -number, 7.0f};
}

bool same_bits(const CellValue& a, const CellValue& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

class CheckpointTest : public testing::Test {
 protected:
  static constexpr std::uint64_t kFingerprint = 0x1234567890abcdef;
  static constexpr std::size_t kCells = 10;
  static constexpr std::size_t kValues = 7;
  static constexpr std::size_t kHeader = 34;

  std::string written() {
    {
      Checkpoint checkpoint(file, kFingerprint, kValues);
      for (std::size_t cell = 1; cell <= kCells; ++cell) checkpoint.append(cell, value_of(cell));
    }
    return read_file(file, 1 << 20);
  }
  // How many of the first cells it finds, each as it was.
  std::size_t found() {
    const Checkpoint checkpoint(file, kFingerprint, kValues);
    for (std::size_t cell = 1; cell <= checkpoint.found().size(); ++cell) {
      EXPECT_TRUE(checkpoint.found().contains(cell) && same_bits(checkpoint.found().at(cell), value_of(cell))) << cell;
    }
    return checkpoint.found().size();
  }
  std::string refusal(std::uint64_t fingerprint = kFingerprint) {
    try {
      const Checkpoint checkpoint(file, fingerprint, kValues);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder / "map.part";
};

TEST_F(CheckpointTest, KeepsValuesToTheBit) {
  written();
  EXPECT_EQ(found(), kCells);
}

TEST_F(CheckpointTest, CutAnywhereKeepsTheCellsBeforeTheCutAndGoesOn) {
  const std::string whole = written();
  const std::size_t record = (whole.size() - kHeader) / kCells;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::filesystem::remove(file);
    folder.write("map.part", whole.substr(0, size));
    const std::size_t expected = size < kHeader ? 0 : (size - kHeader) / record;
    ASSERT_EQ(found(), expected) << "cut at " << size;
    {
      Checkpoint checkpoint(file, kFingerprint, kValues);
      checkpoint.append(expected + 1, value_of(expected + 1));
    }
    ASSERT_EQ(found(), expected + 1) << "cut at " << size;
  }
}

TEST_F(CheckpointTest, DamagedAnywhereGivesNoWrongCell) {
  const std::string whole = written();
  for (std::size_t at = kHeader; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    std::filesystem::remove(file);
    folder.write("map.part", damaged);
    ASSERT_EQ(found(), (at - kHeader) / ((whole.size() - kHeader) / kCells)) << "damaged at " << at;
  }
}

TEST_F(CheckpointTest, OfAnotherBuildOrNoneOfOursIsRefusedAndLeftAlone) {
  const std::string whole = written();
  EXPECT_THAT(refusal(kFingerprint + 1), testing::HasSubstr("holds cells of another build"));
  EXPECT_EQ(read_file(file, 1 << 20), whole);
  std::filesystem::remove(file);
  folder.write("map.part", "notes");
  EXPECT_THAT(refusal(), testing::HasSubstr("is not a checkpoint of ours"));
  EXPECT_EQ(read_file(file, 1 << 20), "notes");
}

TEST_F(CheckpointTest, IsHeldByOneBuildAtATime) {
  const Checkpoint first(file, kFingerprint, kValues);
  EXPECT_THAT(refusal(), testing::HasSubstr("is held by another build that is under way"));
}

TEST_F(CheckpointTest, SaysWhereItCannotBeWritten) {
  file = folder / "no/map.part";
  EXPECT_THAT(refusal(), testing::HasSubstr("cannot be written: No such file or directory"));
}

TEST(Fingerprint, ChangesWithAllThatValuesDependOn) {
  const auto scene = [](double height) { return Scene({test::box({0.0, 0.0, 0.0}, {1.0, 1.0, height})}); };
  const auto map = [](float value) {
    return OccupancyMap(Grid<float>({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 2, .height = 2}, value));
  };
  const LidarModel lidar = test::hdl32e();
  LidarModel noisier = lidar;
  noisier.range_stddev *= 2.0;
  LidarModel higher = lidar;
  higher.T_base_lidar.translation().z() += 0.1;
  const std::uint64_t base = fingerprint(scene(1.0), map(0.0f), lidar, "samples: 1\n", 1);
  EXPECT_EQ(fingerprint(scene(1.0), map(0.0f), lidar, "samples: 1\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.1), map(0.0f), lidar, "samples: 1\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.0), map(1.0f), lidar, "samples: 1\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.0), map(0.0f), noisier, "samples: 1\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.0), map(0.0f), higher, "samples: 1\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.0), map(0.0f), lidar, "samples: 2\n", 1), base);
  EXPECT_NE(fingerprint(scene(1.0), map(0.0f), lidar, "samples: 1\n", 2), base);
}

}  // namespace
}  // namespace alignability::detail
