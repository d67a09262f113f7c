// SPDX-License-Identifier: BSD-3-Clause
#include "localization/cube_index.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace alignability {
namespace {

TEST(CubeOf, OwnsItsLowerFaces) {
  EXPECT_EQ(cube_of({0.0, 0.39, 0.4}, 0.4), (Cube{0, 0, 1}));
  EXPECT_EQ(cube_of({-0.01, -0.4, -0.41}, 0.4), (Cube{-1, -1, -2}));
  EXPECT_EQ(cube_of({1e300, -1e300, 0.0}, 0.4), (Cube{1 << 30, -(1 << 30), 0}));
}

TEST(CubeIndex, NumbersAsAMapDoes) {
  std::mt19937_64 engine(1);
  std::uniform_int_distribution<std::int32_t> uniform(-12, 12);
  const auto drawn = [&] { return Cube{uniform(engine), uniform(engine), uniform(engine)}; };
  CubeIndex index;
  std::map<Cube, std::size_t> expected;
  for (int i = 0; i < 20000; ++i) {
    const Cube cube = drawn();
    const std::size_t number = expected.emplace(cube, expected.size()).first->second;
    ASSERT_EQ(index.number(cube), number);
  }
  for (int i = 0; i < 20000; ++i) {
    const Cube cube = drawn();
    const auto found = expected.find(cube);
    ASSERT_EQ(index.find(cube), found == expected.end() ? std::nullopt : std::optional(found->second));
  }
}

}  // namespace
}  // namespace alignability
