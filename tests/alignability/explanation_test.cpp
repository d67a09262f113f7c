// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/explanation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/pose.hpp"
#include "tests/alignability/patches.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using testing::HasSubstr;

const Eigen::Matrix3d kLevel = Eigen::Matrix3d::Identity();
const Eigen::Vector3f kX = Eigen::Vector3f::UnitX();
const Eigen::Vector3f kY = Eigen::Vector3f::UnitY();
const Eigen::Vector3f kZ = Eigen::Vector3f::UnitZ();

double sum_of(const std::vector<ExplainedPlane>& planes, double ExplainedPlane::*part) {
  double sum = 0.0;
  for (const ExplainedPlane& plane : planes) sum += plane.*part;
  return sum;
}

int segments_of(const std::vector<ExplainedPlane>& planes) {
  int segments = 0;
  for (const ExplainedPlane& plane : planes) segments += plane.segments;
  return segments;
}

int count_of(const std::vector<ExplainedPlane>& planes, PlaneKind kind) {
  return static_cast<int>(std::ranges::count(planes, kind, &ExplainedPlane::kind));
}

// Patches of 30², 20² and 10² points across x, y and z.
Scan uneven_walls() {
  Scan scan;
  test::add_patch(scan, 4.0f * kX, kY, kZ, 30);
  test::add_patch(scan, 4.0f * kY, kZ, kX, 20);
  test::add_patch(scan, -3.0f * kZ, kX, kY, 10);
  return scan;
}

// Patches at random about the sensor, their points noisy.
Scan random_patches(std::mt19937_64& engine) {
  std::normal_distribution<float> normal;
  std::uniform_int_distribution<int> side(12, 30);
  Scan scan;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Quaternionf q = Eigen::Quaternionf(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
    test::add_patch(scan, 4.0f * (i + 1.0f) * (q * kZ), q * kX, q * kY, side(engine));
  }
  for (Eigen::Vector3f& point : scan.points) point += 0.003f * Eigen::Vector3f(normal(engine), normal(engine), normal(engine));
  return scan;
}

TEST(Explanation, OfThreeOrthogonalWallsOfEqualCountsSharesAlike) {
  const Explanation explanation = explain(test::three_walls(), kLevel, 0.0, {});
  ASSERT_EQ(explanation.planes.size(), 3u);
  for (const ExplainedPlane& plane : explanation.planes) {
    EXPECT_DOUBLE_EQ(plane.share, 1.0 / 3.0);
    EXPECT_EQ(plane.points, 400u);
  }
  EXPECT_EQ(count_of(explanation.planes, PlaneKind::wall), 2);
  EXPECT_EQ(count_of(explanation.planes, PlaneKind::floor), 1);
  EXPECT_THAT(
      sentence(explanation, {}),
      HasSubstr("Safe, alpha 1.000: the scan is held in every direction alike: the normals are of walls (66.7 %, 2 planes) and floor"));
}

TEST(Explanation, OfOnePlaneNamesItsPlaceAndSize) {
  Scan scan;
  test::add_patch(scan, Eigen::Vector3f(4.0f, 3.0f, 0.0f), kY, kZ, 20);
  const Explanation explanation = explain(scan, kLevel, 0.0, {});
  ASSERT_EQ(explanation.planes.size(), 1u);
  const ExplainedPlane& plane = explanation.planes.front();
  EXPECT_EQ(plane.kind, PlaneKind::wall);
  EXPECT_NEAR((plane.normal - Eigen::Vector3d(-1.0, 0.0, 0.0)).norm(), 0.0, 1e-6) << "towards the sensor";
  EXPECT_DOUBLE_EQ(plane.share, 1.0);
  EXPECT_NEAR(plane.distance, 4.0, 1e-6);
  EXPECT_NEAR(plane.extents[0], 0.95, 1e-4);
  EXPECT_NEAR(plane.extents[1], 0.95, 1e-4);
  EXPECT_NEAR(plane.extents[2], 0.0, 1e-6);
  EXPECT_THAT(sentence(explanation, {}),
              HasSubstr("Blind, alpha 0.000: nothing faces in any direction square to x: the normals are of walls"));
}

TEST(Explanation, OfUnevenWallsNamesTheOneThatHolds) {
  const Explanation explanation = explain(uneven_walls(), kLevel, 0.0, {});
  ASSERT_EQ(explanation.planes.size(), 3u);
  EXPECT_DOUBLE_EQ(explanation.planes[0].share, 900.0 / 1400.0);
  EXPECT_DOUBLE_EQ(explanation.planes[1].share, 400.0 / 1400.0);
  EXPECT_DOUBLE_EQ(explanation.planes[2].share, 100.0 / 1400.0);
  EXPECT_EQ(explanation.planes[2].kind, PlaneKind::floor);
  EXPECT_NEAR(explanation.planes[2].distance, 3.0, 1e-6);
  EXPECT_NEAR(explanation.planes[2].holds, 1.0, 1e-5);
  EXPECT_NEAR(explanation.noise, 0.0, 1e-5);
  EXPECT_NEAR(explanation.weakest_axis().z(), 1.0, 1e-6);
}

TEST(Explanation, OfAPlainCorridorIsTwoWallsAndAFloorAndWeakAlongIt) {
  for (const bool noisy : {false, true}) {
    SCOPED_TRACE(noisy);
    const auto noise = noisy ? std::optional(NoiseKey{.seed = 1}) : std::nullopt;
    const Explanation explanation = explain(test::scan_of(test::plain_corridor(), noise), kLevel, noisy ? 0.008 : 0.0, {});
    EXPECT_NEAR(explanation.weakest_axis().x(), 1.0, 1e-3);
    ASSERT_EQ(explanation.planes.size(), 3u) << "the strips that noise tears off too are part of what they lie on";
    EXPECT_GT(segments_of(explanation.planes), 3);
    EXPECT_EQ(count_of(explanation.planes, PlaneKind::wall), 2);
    EXPECT_EQ(count_of(explanation.planes, PlaneKind::floor), 1);
    for (const ExplainedPlane& plane : explanation.planes) {
      EXPECT_NEAR(plane.distance, plane.kind == PlaneKind::wall ? 1.5 : 1.9, 0.01);
      EXPECT_NEAR(plane.normal.cwiseAbs()[plane.kind == PlaneKind::wall ? 1 : 2], 1.0, 1e-3);
    }
    EXPECT_THAT(sentence(explanation, {}), testing::MatchesRegex("Blind, alpha 0\\.0.*: nothing faces along x: the normals are of walls "
                                                                 "\\(.*, 2 planes\\) and floor \\(.*, 1 plane\\)\\..*"));
    if (noisy) {
      EXPECT_GT(explanation.noise, 0.99) << "what is left of alpha";
      EXPECT_GT(explanation.planes[2].holds, 0.9) << "the floor's";
    }
  }
}

// Two patches of one wall, and a third a hand's breadth behind it.
TEST(Explanation, CountsWhatLiesInOnePlaneAsOne) {
  Scan scan;
  test::add_patch(scan, Eigen::Vector3f(4.0f, -2.0f, 0.0f), kY, kZ);
  test::add_patch(scan, Eigen::Vector3f(4.0f, 2.0f, 0.0f), kY, kZ);
  test::add_patch(scan, Eigen::Vector3f(4.1f, 6.0f, 0.0f), kY, kZ);
  const Explanation explanation = explain(scan, kLevel, 0.0, {});
  ASSERT_EQ(explanation.planes.size(), 2u);
  EXPECT_EQ(explanation.planes[0].segments, 2);
  EXPECT_EQ(explanation.planes[0].points, 800u);
  EXPECT_NEAR(explanation.planes[0].extents[0], 4.95, 1e-3);
  EXPECT_EQ(explanation.planes[1].segments, 1);
  EXPECT_NEAR(explanation.planes[1].distance, 4.1, 1e-3);
}

TEST(Explanation, OfABareFloorIsHeldByNoiseAlone) {
  const Explanation explanation = explain(test::scan_of(test::floor_and({}), NoiseKey{.seed = 1}), kLevel, 0.008, {});
  EXPECT_EQ(count_of(explanation.planes, PlaneKind::floor), static_cast<int>(explanation.planes.size()));
  EXPECT_GT(explanation.alignability.alpha, 0.05);
  EXPECT_GT(explanation.noise, 0.99);
  EXPECT_THAT(sentence(explanation, {}), HasSubstr("nothing faces in any horizontal direction: the normals are of floor (100.0 %"));
}

TEST(Explanation, OfAScanWithoutPlanesIsEmpty) {
  Scan few;
  test::add_patch(few, 4.0f * kX, kY, kZ, 5);
  for (const Scan& scan : {Scan{}, few}) {
    SCOPED_TRACE(scan.points.size());
    const Explanation explanation = explain(scan, kLevel, 0.01, {});
    EXPECT_TRUE(explanation.planes.empty());
    EXPECT_EQ(explanation.noise, 0.0);
    EXPECT_EQ(explanation.weakest_axis(), Eigen::Vector3d(Eigen::Vector3d::Zero()));
    EXPECT_EQ(explanation.plane_of_point, std::vector<int>(scan.points.size(), -1));
    EXPECT_EQ(explanation.alignability.points, scan.points.size());
  }
}

TEST(Explanation, KnowsCeilingsAndSlopes) {
  Scan scan;
  test::add_patch(scan, 2.0f * kZ, kX, kY);
  test::add_patch(scan, 5.0f * (kX - kZ).normalized(), kY, (kX + kZ).normalized());
  const Explanation explanation = explain(scan, kLevel, 0.0, {});
  EXPECT_EQ(count_of(explanation.planes, PlaneKind::ceiling), 1);
  EXPECT_EQ(count_of(explanation.planes, PlaneKind::slope), 1);
}

TEST(Explanation, SharesAndHoldsSumToOneAndAgreeWithTheScore) {
  for (const Moment moment : {Moment::about_origin, Moment::about_mean}) {
    AlignabilityOptions options;
    options.moment = moment;
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937_64 engine(seed);
      const Scan scan = random_patches(engine);
      const ScoredScan scored = score(scan, options);
      const Explanation explanation = explain(scan, kLevel, 0.003, options);
      EXPECT_EQ(segments_of(explanation.planes), scored.alignability.planes_kept);
      ASSERT_GT(scored.alignability.eigenvalues[2], 0.0);
      EXPECT_NEAR(sum_of(explanation.planes, &ExplainedPlane::share), 1.0, 1e-12);
      EXPECT_NEAR(sum_of(explanation.planes, &ExplainedPlane::holds), 1.0, 1e-12);
      EXPECT_EQ(explanation.alignability.alpha, scored.alignability.alpha);
      EXPECT_TRUE(std::ranges::is_sorted(explanation.planes, std::ranges::greater{}, &ExplainedPlane::points));
      for (std::size_t i = 0; i < scan.points.size(); ++i) {
        ASSERT_EQ(explanation.plane_of_point[i] < 0, scored.plane_of_point[i] < 0);
      }
    }
  }
}

// λ_c, plane by plane and from the normals that the score gives.
TEST(Explanation, HoldsIsEachPlanesPartOfTheLeastEigenvalue) {
  for (const Moment moment : {Moment::about_origin, Moment::about_mean}) {
    std::mt19937_64 engine(7);
    const Scan scan = random_patches(engine);
    AlignabilityOptions options;
    options.moment = moment;
    const ScoredScan scored = score(scan, options);
    const Explanation explanation = explain(scan, kLevel, 0.003, options);
    std::vector<std::vector<double>> along(explanation.planes.size());
    double count = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (explanation.plane_of_point[i] < 0) continue;
      const double part = scored.normals[i].cast<double>().dot(scored.alignability.weakest_direction);
      along[static_cast<std::size_t>(explanation.plane_of_point[i])].push_back(part);
      mean += part;
      ++count;
    }
    mean = moment == Moment::about_mean ? mean / count : 0.0;
    for (std::size_t plane = 0; plane < along.size(); ++plane) {
      double sum = 0.0;
      for (const double part : along[plane]) sum += (part - mean) * (part - mean);
      EXPECT_NEAR(explanation.planes[plane].holds, sum / (count * scored.alignability.eigenvalues[2]), 1e-9);
    }
  }
}

TEST(Explanation, AboutTheMeanANoisyWallIsHeldByNoiseAlone) {
  std::mt19937_64 engine(3);
  std::normal_distribution<float> normal;
  Scan scan;
  test::add_patch(scan, 4.0f * kX, kY, kZ, 30);
  for (Eigen::Vector3f& point : scan.points) point += 0.003f * Eigen::Vector3f(normal(engine), normal(engine), normal(engine));
  AlignabilityOptions options;
  options.moment = Moment::about_mean;
  EXPECT_GT(explain(scan, kLevel, 0.003, options).noise, 0.999);
}

TEST(Explanation, TurnsDirectionsToTheMapAndNothingElse) {
  const Scan scan = uneven_walls();
  const Explanation level = explain(scan, kLevel, 0.0, {});
  const Eigen::Matrix3d R_map_lidar = Eigen::AngleAxisd(radians(90.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Explanation turned = explain(scan, R_map_lidar, 0.0, {});
  EXPECT_EQ(turned.alignability.alpha, level.alignability.alpha);
  for (std::size_t i = 0; i < level.planes.size(); ++i) {
    EXPECT_NEAR((turned.planes[i].normal - R_map_lidar * level.planes[i].normal).norm(), 0.0, 1e-12);
    EXPECT_EQ(turned.planes[i].holds, level.planes[i].holds);
    EXPECT_EQ(turned.planes[i].distance, level.planes[i].distance);
  }
  EXPECT_EQ(level.planes[1].kind, PlaneKind::wall) << "to the left, along y of the lidar";
  EXPECT_EQ(turned.planes[1].kind, PlaneKind::ceiling) << "overhead, where y of the lidar points up";
  EXPECT_NEAR(turned.weakest_axis().y(), 1.0, 1e-6);
}

}  // namespace
}  // namespace alignability
