// SPDX-License-Identifier: BSD-3-Clause
#include "planner/headings.hpp"

#include <gtest/gtest.h>

namespace alignability {
namespace {

constexpr double kUp = std::numbers::pi / 2.0;

TEST(Headings, LookToTheNextPlaceAndAtTheEndAsBefore) {
  const std::vector<Pose2> path = looking_ahead({{0, 0, 9}, {2, 0, 9}, {2, 3, 9}}, 1.0);
  EXPECT_EQ(path, (std::vector<Pose2>{{0, 0, 0}, {2, 0, kUp}, {2, 3, kUp}}));
}

TEST(Headings, DoNotTurnWhereAPlaceIsRepeated) {
  const std::vector<Pose2> path = looking_ahead({{0, 0, 9}, {0, 0, 9}, {0, 1, 9}, {0, 1, 9}, {0, 1, 9}}, 1.0);
  for (const Pose2& pose : path) EXPECT_EQ(pose.yaw, kUp);
}

TEST(Headings, OfAPathThatStaysInOnePlaceAreGiven) {
  EXPECT_EQ(looking_ahead({{4, 5, 9}}, 1.0), (std::vector<Pose2>{{4, 5, 1.0}}));
  EXPECT_EQ(looking_ahead({{4, 5, 9}, {4, 5, 8}}, 1.0), (std::vector<Pose2>{{4, 5, 1.0}, {4, 5, 1.0}}));
  EXPECT_TRUE(looking_ahead({}, 1.0).empty());
}

TEST(Headings, AreHeldUntilTheCornerAndTurnedThere) {
  const std::vector<Pose2> path = turning_on_the_spot(looking_ahead({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 3, 0}}, 0.0));
  EXPECT_EQ(path, (std::vector<Pose2>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, kUp}, {2, 3, kUp}}));
}

}  // namespace
}  // namespace alignability
