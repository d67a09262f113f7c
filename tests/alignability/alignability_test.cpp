// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/alignability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/alignability/patches.hpp"
#include "tests/alignability/simulated.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::box;
using test::floor_and;
using test::scan_of;

const Eigen::Vector3f kX = Eigen::Vector3f::UnitX();
const Eigen::Vector3f kY = Eigen::Vector3f::UnitY();
const Eigen::Vector3f kZ = Eigen::Vector3f::UnitZ();

TEST(Alignability, OfOnePlaneIsZero) {
  Scan scan;
  test::add_patch(scan, 4.0f * kX, kY, kZ);
  const Alignability result = score(scan, {}).alignability;
  EXPECT_NEAR(result.alpha, 0.0, 1e-6);
  EXPECT_EQ(result.planes_kept, 1);
  EXPECT_NEAR(result.eigenvalues[0], 1.0, 1e-5);
}

TEST(Alignability, OfThreeOrthogonalWallsOfEqualCountsIsOne) {
  const Alignability result = score(test::three_walls(), {}).alignability;
  EXPECT_NEAR(result.alpha, 1.0, 1e-4);
  EXPECT_EQ(result.planes_kept, 3);
  EXPECT_EQ(result.points, 1200u);
  EXPECT_NEAR(result.eigenvalues.sum(), 1.0, 1e-5);
}

TEST(Alignability, OfThreeWallsIsZeroWhenTheMeanIsSubtractedAsTheDesignNotes) {
  AlignabilityOptions centred;
  centred.moment = Moment::about_mean;
  EXPECT_NEAR(score(test::three_walls(), centred).alignability.alpha, 0.0, 1e-4);
}

TEST(Alignability, IsTheRatioOfCountsWhereNormalsAreOrthogonal) {
  Scan scan;
  test::add_patch(scan, 4.0f * kX, kY, kZ, 30);
  test::add_patch(scan, 4.0f * kY, kZ, kX, 20);
  test::add_patch(scan, -3.0f * kZ, kX, kY, 10);
  const Alignability result = score(scan, {}).alignability;
  EXPECT_NEAR(result.alpha, 100.0 / 900.0, 1e-4);
  EXPECT_NEAR(std::abs(result.weakest_direction.z()), 1.0, 1e-4);
}

TEST(Alignability, OfAPlainCorridorWithoutNoiseIsZeroAndWeakAlongIt) {
  const Scan scan = scan_of(test::plain_corridor());
  const Alignability result = score(scan, {}).alignability;
  EXPECT_LT(result.alpha, 1e-4);
  EXPECT_GE(result.planes_kept, 3);
  EXPECT_NEAR(std::abs(result.weakest_direction.x()), 1.0, 1e-3);
}

TEST(Alignability, OfARoomIsFarAboveThatOfACorridor) {
  // Walls near enough to be seen, far enough that the lowest rings meet the floor before them, at 3.2 m.
  const Scan scan = scan_of(floor_and({box({-4.7, 4.5, 0.0}, {4.7, 4.7, 5.0}), box({-4.7, -4.7, 0.0}, {4.7, -4.5, 5.0}),
                                       box({4.5, -4.5, 0.0}, {4.7, 4.5, 5.0}), box({-4.7, -4.5, 0.0}, {-4.5, 4.5, 5.0})}),
                            NoiseKey{.seed = 1});
  EXPECT_GT(score(scan, {}).alignability.alpha, 0.3);
}

TEST(Alignability, OfACylinderIsZeroForItIsNoPlane) {
  Scan scan;
  for (int ring = 0; ring < 40; ++ring) {
    for (int step = 0; step < 400; ++step) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(step) / 400.0f;
      scan.points.emplace_back(3.0f * std::cos(angle), 3.0f * std::sin(angle), 0.05f * static_cast<float>(ring));
    }
  }
  const Alignability result = score(scan, {}).alignability;
  EXPECT_EQ(result.alpha, 0.0);
  EXPECT_EQ(result.planes_kept, 0);
  EXPECT_EQ(result.weakest_direction, Eigen::Vector3d(Eigen::Vector3d::Zero()));
}

TEST(Alignability, OfNothingIsZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Scan few;
  test::add_patch(few, 4.0f * kX, kY, kZ, 7);
  Scan one;
  one.points.emplace_back(1.0f, 0.0f, 0.0f);
  Scan none_returned;
  none_returned.points.assign(1000, Eigen::Vector3f::Constant(nan));
  Scan all_near;
  all_near.points.assign(1000, Eigen::Vector3f::Zero());
  Scan all_one_point;
  all_one_point.points.assign(1000, Eigen::Vector3f(1.0f, 2.0f, 3.0f));
  for (const Scan& scan : {Scan{}, one, few, none_returned, all_near, all_one_point}) {
    SCOPED_TRACE(scan.points.size());
    const ScoredScan result = score(scan, {});
    EXPECT_EQ(result.alignability.alpha, 0.0);
    EXPECT_EQ(result.plane_of_point.size(), scan.points.size());
  }
}

TEST(Alignability, DropsReturnsNearerThanTheMinimumRange) {
  Scan scan = test::three_walls();
  const double before = score(scan, {}).alignability.alpha;
  test::add_patch(scan, 0.1f * kX, kY, kZ, 8);
  const ScoredScan after = score(scan, {});
  EXPECT_EQ(after.alignability.points, 1200u);
  EXPECT_EQ(after.alignability.alpha, before);
  EXPECT_EQ(after.plane_of_point.back(), -1);
}

TEST(Alignability, DropsPlanesThatAreTooSmall) {
  Scan scan = test::three_walls();
  AlignabilityOptions options;
  options.min_area = 0.95 * 0.95 + 0.01;  // each patch is 0.95 m a side
  const Alignability result = score(scan, options).alignability;
  EXPECT_EQ(result.planes_found, 3);
  EXPECT_EQ(result.planes_kept, 0);
  EXPECT_EQ(result.alpha, 0.0);
}

TEST(Alignability, IsInvariantUnderRotation) {
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  Scan scan = test::three_walls(20);
  test::add_patch(scan, 3.5f * (kX + kY).normalized(), (kX - kY).normalized(), kZ, 15);
  const double before = score(scan, {}).alignability.alpha;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Quaterniond q = Eigen::Quaterniond(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
    Scan moved = scan;
    for (Eigen::Vector3f& point : moved.points) point = q.cast<float>() * point;
    EXPECT_NEAR(score(moved, {}).alignability.alpha, before, 1e-3);
  }
}

TEST(Alignability, IsInvariantUnderTranslationAndOrderOfPoints) {
  std::mt19937_64 engine(4);
  Scan scan = test::three_walls();
  const double before = score(scan, {}).alignability.alpha;
  for (Eigen::Vector3f& point : scan.points) point += Eigen::Vector3f(10.0f, -20.0f, 5.0f);
  EXPECT_NEAR(score(scan, {}).alignability.alpha, before, 1e-3);
  std::shuffle(scan.points.begin(), scan.points.end(), engine);
  EXPECT_NEAR(score(scan, {}).alignability.alpha, before, 1e-3);
}

TEST(Alignability, NamesThePlaneOfEachPoint) {
  const ScoredScan result = score(test::three_walls(), {});
  for (int wall = 0; wall < 3; ++wall) {
    const int plane = result.plane_of_point[static_cast<std::size_t>(400 * wall)];
    EXPECT_GE(plane, 0);
    for (int i = 0; i < 400; ++i) EXPECT_EQ(result.plane_of_point[static_cast<std::size_t>(400 * wall + i)], plane);
  }
}

TEST(Alignability, OptionsAreWrittenOutWhole) {
  AlignabilityOptions options;
  const std::string text =
      "engine: native\nengine_revision: 2\nmin_range: 0.5\nnormal_neighbours: 30\ngrowing_neighbours: 15\nsmoothness_deg: 3\n"
      "curvature: 1\nmin_points: 50\nstride: 1\nplane_threshold: 0.05\nmin_area: 0.01\ncentred: false\n";
  EXPECT_EQ(to_yaml(options), text);
  options.readings = {Reading::robust, Reading::information};
  EXPECT_EQ(to_yaml(options), text + "readings: [robust, information]\nvoxel: 0.08\nrange_stddev: 0.02\n");
}

}  // namespace
}  // namespace alignability
