// SPDX-License-Identifier: BSD-3-Clause
// The native engine beside PCL, whose answer it gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "alignability/alignability.hpp"
#include "lidar/scan_file.hpp"
#include "tests/alignability/patches.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

AlignabilityOptions with(Engine engine) {
  AlignabilityOptions options;
  options.segmentation.engine = engine;
  return options;
}

void expect_agreement(const Scan& scan) {
  const Alignability native = score(scan, with(Engine::native)).alignability;
  const Alignability pcl = score(scan, with(Engine::pcl)).alignability;
  EXPECT_EQ(native.points, pcl.points);
  EXPECT_NEAR(native.alpha, pcl.alpha, 5e-3);
  EXPECT_GT(pcl.planes_kept, 0);
}

std::vector<TriangleMesh> corner() {
  return test::floor_and({test::box({3.0, -50.0, 0.0}, {3.2, 50.0, 4.0}), test::box({-50.0, 2.0, 0.0}, {50.0, 2.2, 4.0})});
}

TEST(Engines, AgreeInACorridorAndACornerWithNoiseAndWithout) {
  for (const auto& site : {test::plain_corridor(), corner()}) {
    expect_agreement(test::scan_of(site));
    expect_agreement(test::scan_of(site, NoiseKey{.seed = 3}));
  }
}

TEST(Engines, AgreeOnAScanWithoutOrder) {
  Scan scan = test::scan_of(corner(), NoiseKey{.seed = 4});
  std::mt19937_64 engine(5);
  std::shuffle(scan.points.begin(), scan.points.end(), engine);
  scan.columns = static_cast<int>(scan.points.size());
  scan.rings = 1;
  expect_agreement(scan);
}

TEST(Engines, AgreeOnRealScans) {
  for (const char* file : {"scans/hdl32-pair/251370668.pcd", "scans/hdl32-street/hdl32_rev1.pcd", "scans/room/room_scan1.pcd"}) {
    ALIGNABILITY_REQUIRE_SHARED_DATA(path, file);
    SCOPED_TRACE(file);
    expect_agreement(read_scan_file(path));
  }
}

TEST(Scorer, RemembersNothingOfTheScansBefore) {
  const Scan first = test::scan_of(test::plain_corridor(), NoiseKey{.seed = 1});
  const Scan second = test::scan_of(corner(), NoiseKey{.seed = 2});
  Scorer scorer{AlignabilityOptions{}};
  const double before = scorer.alignability(first).alpha;
  EXPECT_EQ(scorer.alignability(second).alpha, score(second, {}).alignability.alpha);
  EXPECT_EQ(scorer.alignability(test::three_walls()).alpha, score(test::three_walls(), {}).alignability.alpha);
  EXPECT_EQ(scorer.alignability({}).alpha, 0.0);
  EXPECT_EQ(scorer.alignability(first).alpha, before);
}

TEST(Scorer, SaysOfAScanTheSameWithItsPlanesAndWithout) {
  const Scan scan = test::scan_of(corner(), NoiseKey{.seed = 2});
  Scorer scorer{AlignabilityOptions{}};
  const ScoredScan scored = scorer.score(scan);
  EXPECT_EQ(scored.alignability.alpha, scorer.alignability(scan).alpha);
  EXPECT_EQ(1 + *std::ranges::max_element(scored.plane_of_point), scored.alignability.planes_kept);
}

TEST(Scorer, TakesScansOfAFewPointsOfOneAndOfNone) {
  const Eigen::Vector3f nan = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  for (const Engine engine : {Engine::native, Engine::pcl}) {
    Scorer scorer{with(engine)};
    EXPECT_EQ(scorer.alignability({.points = {}, .rings = 1, .columns = 0}).alpha, 0.0);
    EXPECT_EQ(scorer.alignability({.points = {nan, nan}, .rings = 2, .columns = 1}).points, 0u);
    EXPECT_EQ(scorer.alignability({.points = std::vector<Eigen::Vector3f>(29, {1.0f, 2.0f, 3.0f}), .rings = 1, .columns = 29}).points, 29u);
    EXPECT_EQ(scorer.alignability({.points = std::vector<Eigen::Vector3f>(60, {1.0f, 2.0f, 3.0f}), .rings = 2, .columns = 30}).alpha, 0.0);
  }
}

TEST(Stride, VotesByEveryNthColumnAlone) {
  const Scan scan = test::scan_of(corner(), NoiseKey{.seed = 6});
  AlignabilityOptions options;
  options.segmentation.stride = 4;
  const ScoredScan scored = score(scan, options);
  EXPECT_NEAR(scored.alignability.alpha, score(scan, {}).alignability.alpha, 0.05);
  EXPECT_EQ(scored.alignability.points, score(scan, {}).alignability.points);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const bool votes = static_cast<int>(i) % scan.columns % 4 == 0;
    if (!votes) {
      ASSERT_TRUE(scored.normals[i].hasNaN());
    } else {
      ASSERT_EQ(scored.normals[i].allFinite(), scan.points[i].allFinite());
    }
  }
}

TEST(Stride, MakesNoDifferenceToAScanWithoutOrder) {
  AlignabilityOptions options;
  options.segmentation.stride = 4;
  EXPECT_EQ(score(test::three_walls(), options).alignability.alpha, score(test::three_walls(), {}).alignability.alpha);
}

TEST(Engines, AgreeWithMoreNeighboursToGrowByThanForNormals) {
  const Scan scan = test::scan_of(corner(), NoiseKey{.seed = 4});
  AlignabilityOptions native = with(Engine::native), pcl = with(Engine::pcl);
  for (AlignabilityOptions* options : {&native, &pcl}) {
    options->segmentation.normal_neighbours = 20;
    options->segmentation.growing_neighbours = 40;
  }
  EXPECT_NEAR(score(scan, native).alignability.alpha, score(scan, pcl).alignability.alpha, 5e-3);
}

TEST(Stride, OfLessThanOneOfMoreThanFourOrWithPclIsRefused) {
  AlignabilityOptions options;
  for (const int stride : {0, 5}) {
    options.segmentation.stride = stride;
    EXPECT_THROW(Scorer{options}, std::invalid_argument);
  }
  options.segmentation.stride = 2;
  options.segmentation.engine = Engine::pcl;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
}

}  // namespace
}  // namespace alignability
