// SPDX-License-Identifier: BSD-3-Clause
#include "localization/moved_objects.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

std::vector<TriangleMesh> pallets_and_a_wall() {
  std::vector<TriangleMesh> meshes{box({-1.0, 20.0, 0.0}, {200.0, 20.2, 3.0})};
  for (int i = 0; i < 100; ++i) {
    const double x = 2.0 * i;
    meshes.push_back(box({x, 0.0, 0.0}, {x + 1.2, 0.8, 1.4}));
  }
  return meshes;
}

TEST(MovedObjects, AreTheShareAskedForOfWhatIsNoLargerThanAPallet) {
  const MovedObjects site = with_moved_objects(pallets_and_a_wall(), 0.2, 1);
  EXPECT_EQ(site.movable, 100u);
  EXPECT_GE(site.moved, 10u);
  EXPECT_LE(site.moved, 30u) << "20 in the mean, 4 the standard deviation";
  const auto before = pallets_and_a_wall();
  std::size_t elsewhere = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Eigen::Vector3f shift = bounds(site.meshes[i]).center() - bounds(before[i]).center();
    if (shift.norm() < 1e-3f) continue;
    ++elsewhere;
    EXPECT_NEAR(shift.z(), 0.0f, 1e-5f);
    EXPECT_GE(shift.norm(), 0.2f - 1e-4f);
    EXPECT_LE(shift.norm(), 1.0f + 1e-4f);
    EXPECT_NE(i, 0u) << "the wall stays";
  }
  EXPECT_EQ(elsewhere, site.moved);
}

TEST(MovedObjects, AreAllOrNoneAtTheEndsAndAlikeWithTheSameSeed) {
  EXPECT_EQ(with_moved_objects(pallets_and_a_wall(), 0.0, 1).moved, 0u);
  EXPECT_EQ(with_moved_objects(pallets_and_a_wall(), 1.0, 1).moved, 100u);
  EXPECT_EQ(with_moved_objects(pallets_and_a_wall(), 0.3, 7).meshes[5].vertices,
            with_moved_objects(pallets_and_a_wall(), 0.3, 7).meshes[5].vertices);
  EXPECT_THROW(with_moved_objects({}, 1.5, 1), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
