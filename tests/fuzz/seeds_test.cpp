// SPDX-License-Identifier: BSD-3-Clause
// What the fuzzers start from, and what they found: seeds/READER/… must each be read, or refused by InputError. Those called good… are
// read; those called hang… take a library as long as it is let.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "tests/fuzz/readers.hpp"

namespace alignability {
namespace {

class Seeds : public ::testing::TestWithParam<test::FuzzedReader> {
 protected:
  std::vector<std::filesystem::path> files() const {
    const std::filesystem::path folder = std::filesystem::path(ALIGNABILITY_SEEDS) / GetParam().name;
    std::vector<std::filesystem::path> files(std::filesystem::directory_iterator(folder), {});
    std::ranges::sort(files);
    return files;
  }
};

TEST_P(Seeds, AreReadOrRefused) {
  const test::FuzzedFile file(GetParam());
  bool any_good = false;
  for (const std::filesystem::path& seed : files()) {
    const bool good = seed.filename().string().starts_with("good");
    any_good = any_good || good;
    const std::string bytes = read_file(seed, 1 << 24);
    EXPECT_NO_THROW({ EXPECT_TRUE(file.read(bytes) || !good) << seed; }) << seed;
  }
  EXPECT_TRUE(any_good) << "a fuzzer needs something to start from that is read";
}

TEST_P(Seeds, AreReadOrRefusedCutShortAnywhere) {
  const test::FuzzedFile file(GetParam());
  for (const std::filesystem::path& seed : files()) {
    if (seed.filename().string().starts_with("hang")) continue;
    const std::string bytes = read_file(seed, 1 << 24);
    const std::size_t step = std::max<std::size_t>(1, bytes.size() / 64);
    for (std::size_t size = 0; size < bytes.size(); size += step) EXPECT_NO_THROW(file.read(bytes.substr(0, size))) << seed << ", " << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Seeds, ::testing::ValuesIn(test::fuzzed_readers().begin(), test::fuzzed_readers().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace alignability
