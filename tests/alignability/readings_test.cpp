// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/readings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <random>
#include <stdexcept>

#include "alignability/alignability.hpp"
#include "alignability/information.hpp"
#include "core/pose.hpp"
#include "lidar/thinning.hpp"
#include "tests/alignability/patches.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

AlignabilityOptions reading(std::vector<Reading> readings, double range_stddev = 0.02) {
  AlignabilityOptions options;
  options.readings = std::move(readings);
  options.range_stddev = range_stddev;
  return options;
}

// What an HDL-32E with 2 cm of noise sees.
Scan noisy_scan(std::vector<TriangleMesh> meshes, std::uint64_t seed = 1) {
  LidarModel lidar = test::hdl32e();
  lidar.range_stddev = 0.02;
  Eigen::Isometry3d T_map_lidar = Eigen::Isometry3d::Identity();
  T_map_lidar.translation().z() = 1.9;
  return simulate_scan(Scene(std::move(meshes)), lidar, T_map_lidar, {.range_max = 6.5}, NoiseKey{.seed = seed});
}

TEST(Readings, AreNanWhereNotAskedFor) {
  const Readings readings = score(test::three_walls(), {}).alignability.readings;
  for (const double value : {readings.centred, readings.voxel, readings.robust, readings.information.least, readings.information.yaw,
                             readings.information.matrix(0, 0), readings.information.weakest_direction.x()}) {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(Readings, LeaveAlphaAsItIs) {
  const Scan scan = noisy_scan(test::plain_corridor());
  const auto all = reading({Reading::centred, Reading::voxel, Reading::robust, Reading::information});
  EXPECT_EQ(score(scan, all).alignability.alpha, score(scan, {}).alignability.alpha);
  EXPECT_EQ(score(scan, all).plane_of_point, score(scan, {}).plane_of_point);
}

TEST(Readings, WithoutPlanesAreZero) {
  const auto readings = score({}, reading({Reading::centred, Reading::voxel, Reading::robust, Reading::information})).alignability.readings;
  EXPECT_EQ(readings.centred, 0.0);
  EXPECT_EQ(readings.voxel, 0.0);
  EXPECT_EQ(readings.robust, 0.0);
  EXPECT_EQ(readings.information.least, 0.0);
  EXPECT_EQ(readings.information.yaw, 0.0);
  EXPECT_TRUE(readings.information.matrix.isZero());
}

TEST(Centred, IsTheAlphaAboutTheMean) {
  const Scan scan = noisy_scan(test::plain_corridor());
  AlignabilityOptions about_mean;
  about_mean.moment = Moment::about_mean;
  EXPECT_NEAR(score(scan, reading({Reading::centred})).alignability.readings.centred, score(scan, about_mean).alignability.alpha, 1e-12);
  EXPECT_NEAR(score(test::three_walls(), reading({Reading::centred})).alignability.readings.centred, 0.0, 1e-6);
}

TEST(Voxel, IsTheAlphaOfTheThinnedScan) {
  const Scan scan = noisy_scan(test::plain_corridor());
  Scan thin{.points = thinned(scan.points, 0.08), .rings = 1, .columns = 0};
  thin.columns = static_cast<int>(thin.points.size());
  const double expected = score(thin, {}).alignability.alpha;
  EXPECT_LT(thin.points.size(), scan.points.size() / 2);
  EXPECT_EQ(score(scan, reading({Reading::voxel})).alignability.readings.voxel, expected);
  AlignabilityOptions strided = reading({Reading::voxel});  // a thinned scan has no columns
  strided.segmentation.stride = 4;
  EXPECT_EQ(score(scan, strided).alignability.readings.voxel, expected);
}

TEST(Robust, ReadsABareFloorAsNothingWhereNoiseMakesAlphaOfIt) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const int stride : {1, 4}) {
      AlignabilityOptions options = reading({Reading::robust, Reading::information});
      options.segmentation.stride = stride;
      const Alignability floor = score(noisy_scan(test::floor_and({}), seed), options).alignability;
      EXPECT_GT(floor.alpha, 0.01);
      EXPECT_LT(floor.readings.robust, 1e-3) << "seed " << seed << ", stride " << stride;
      // A tenth of a metre, a degree: what a single line of a wall would give is a thousand times that.
      EXPECT_LT(floor.readings.information.least, 1.0 / (0.1 * 0.1)) << "seed " << seed << ", stride " << stride;
      EXPECT_LT(floor.readings.information.yaw, 1.0 / (radians(1) * radians(1))) << "seed " << seed << ", stride " << stride;
    }
  }
}

// Those that vote stand for the columns between; which planes are kept differs a little.
TEST(Information, IsOfAllPointsWhateverTheStride) {
  const Scan scan =
      test::scan_of(test::floor_and({test::box({3.0, -50.0, 0.0}, {3.2, 50.0, 4.0}), test::box({-50.0, 2.0, 0.0}, {50.0, 2.2, 4.0})}),
                    NoiseKey{.seed = 1});
  AlignabilityOptions options = reading({Reading::information}, 0.008);
  const PlanarInformation all = score(scan, options).alignability.readings.information;
  options.segmentation.stride = 4;
  const PlanarInformation strided = score(scan, options).alignability.readings.information;
  EXPECT_NEAR(strided.least / all.least, 1.0, 0.1);
  EXPECT_NEAR(strided.yaw / all.yaw, 1.0, 0.1);
}

TEST(Robust, ReadsACorridorAsNothingAndThreeWallsAsOne) {
  const Alignability corridor = score(noisy_scan(test::plain_corridor()), reading({Reading::robust})).alignability;
  EXPECT_GT(corridor.alpha, 10.0 * corridor.readings.robust);
  EXPECT_LT(corridor.readings.robust, 1e-3);
  EXPECT_NEAR(score(test::three_walls(), reading({Reading::robust})).alignability.readings.robust, 1.0, 1e-6);
}

TEST(Information, OfThreeWallsIsWhatTheirPointsAddUpTo) {
  constexpr double kPoints = 400.0;
  constexpr double kVariance = 0.01 * 0.01;
  const PlanarInformation information = score(test::three_walls(), reading({Reading::information}, 0.01)).alignability.readings.information;
  EXPECT_NEAR(information.least, kPoints / kVariance, 1e-3 * kPoints / kVariance);
  // 20 points 5 cm apart, about the middle.
  const double spread = 0.05 * 0.05 * (20.0 * 20.0 - 1.0) / 12.0;
  EXPECT_NEAR(information.yaw, 2.0 * kPoints * spread / kVariance, 1e-3 * information.yaw);
}

TEST(Information, AlongAPlainCorridorIsNextToNone) {
  const PlanarInformation information =
      score(noisy_scan(test::plain_corridor()), reading({Reading::information})).alignability.readings.information;
  EXPECT_GT(std::abs(information.weakest_direction.x()), 0.999);
  EXPECT_LT(information.least, 1e-4 * information.matrix(1, 1));
  EXPECT_GT(information.yaw, 1e6);
}

TEST(Information, IsOfTheRobotWhereverItsLidarIsMounted) {
  const Scan seen =
      noisy_scan(test::floor_and({test::box({3.0, -50.0, 0.0}, {3.2, 50.0, 4.0}), test::box({-50.0, 2.0, 0.0}, {50.0, 2.2, 4.0})}));
  const PlanarInformation level = score(seen, reading({Reading::information})).alignability.readings.information;
  AlignabilityOptions options = reading({Reading::information});
  options.T_base_scan = Eigen::Translation3d(0.4, -0.2, 1.9) * Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.2, -0.3, 1.0).normalized());
  Scan turned = seen;
  const Eigen::Isometry3f T_lidar_base = options.T_base_scan.inverse().cast<float>();
  for (Eigen::Vector3f& point : turned.points) point = T_lidar_base * (point + Eigen::Vector3f(0.0f, 0.0f, 1.9f));
  const PlanarInformation mounted = score(turned, options).alignability.readings.information;
  EXPECT_NEAR(mounted.least, level.least, 0.02 * level.least);
  EXPECT_NEAR(mounted.yaw, level.yaw, 0.02 * level.yaw);
}

TEST(Information, IsTheSumOverPointsOfTheirPlanesNormals) {
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Eigen::Vector3d(normal(engine), normal(engine), normal(engine)); };
  for (int round = 0; round < 100; ++round) {
    Scan scan;
    std::vector<detail::MergedPlane> planes(3);
    Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
    const Eigen::Isometry3d T_base_lidar = Eigen::Translation3d(vector()) * Eigen::AngleAxisd(normal(engine), vector().normalized());
    constexpr double kStddev = 0.5;
    for (detail::MergedPlane& plane : planes) {
      plane.own_normal = vector().normalized();
      const Eigen::Vector3d center = 3.0 * vector();
      for (int k = 0; k < 20; ++k) {
        plane.members.push_back(static_cast<std::int32_t>(scan.points.size()));
        scan.points.push_back((center + vector()).cast<float>());
        plane.normals.push_back(plane.own_normal);
        const Eigen::Vector3d n = T_base_lidar.linear() * plane.own_normal;
        const Eigen::Vector3d p = T_base_lidar * scan.points.back().cast<double>();
        const Eigen::Vector3d j(n.x(), n.y(), p.cross(n).z());
        expected += j * j.transpose() / (kStddev * kStddev);
      }
      plane.shape = detail::shape_of(scan, plane.members);
    }
    const Eigen::Matrix3d matrix = detail::planar_information(planes, T_base_lidar, kStddev, 1).matrix;
    EXPECT_LT((matrix - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST(Information, OfPlaceAndYawIsThatOfTheInverseWhereThereIsOne) {
  std::mt19937_64 engine(4);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 200; ++round) {
    Eigen::Matrix3d root;
    for (double& value : root.reshaped()) value = normal(engine);
    const Eigen::Matrix3d matrix = root * root.transpose() + 0.01 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d covariance = matrix.inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> place(covariance.topLeftCorner<2, 2>());
    const PlanarInformation information = detail::marginal_information(matrix);
    EXPECT_NEAR(information.least * place.eigenvalues()[1], 1.0, 1e-9);
    EXPECT_NEAR(std::abs(information.weakest_direction.dot(place.eigenvectors().col(1))), 1.0, 1e-6);
    EXPECT_NEAR(information.yaw * covariance(2, 2), 1.0, 1e-9);
  }
}

TEST(Information, IsZeroWhereNothingHolds) {
  const PlanarInformation along_y = detail::marginal_information(Eigen::Vector3d(0.0, 5.0, 2.0).asDiagonal());
  EXPECT_EQ(along_y.least, 0.0);
  EXPECT_NEAR(std::abs(along_y.weakest_direction.x()), 1.0, 1e-12);
  EXPECT_EQ(along_y.yaw, 2.0);
  // A place and a yaw that are known but for their sum.
  Eigen::Matrix3d tied = Eigen::Vector3d(3.0, 5.0, 3.0).asDiagonal();
  tied(0, 2) = tied(2, 0) = 3.0;
  EXPECT_EQ(detail::marginal_information(tied).least, 0.0);
  EXPECT_EQ(detail::marginal_information(tied).yaw, 0.0);
  EXPECT_EQ(detail::marginal_information(Eigen::Matrix3d::Zero()).least, 0.0);
}

TEST(Readings, OfACubeOrNoiseWithoutSizeAreRefused) {
  AlignabilityOptions options;
  options.voxel = 0.0;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
  options = {};
  options.range_stddev = 0.0;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
}

TEST(Scorer, RefusesTooFewNeighboursAndAReadingAskedForTwice) {
  AlignabilityOptions options;
  options.segmentation.normal_neighbours = 2;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
  options = {};
  options.segmentation.growing_neighbours = 0;
  EXPECT_THROW(Scorer{options}, std::invalid_argument);
  EXPECT_THROW(Scorer{reading({Reading::voxel, Reading::voxel})}, std::invalid_argument);
}

TEST(ForLidar, TakesLeastRangeNoiseAndMountFromTheModel) {
  const LidarModel lidar = test::hdl32e();
  const AlignabilityOptions options = for_lidar({}, lidar);
  EXPECT_EQ(options.segmentation.range_min, lidar.range_min);
  EXPECT_EQ(options.range_stddev, lidar.range_stddev);
  EXPECT_TRUE(options.T_base_scan.isApprox(lidar.T_base_lidar));
  LidarModel silent = lidar;
  silent.range_stddev = 0.0;
  EXPECT_GT(for_lidar({}, silent).range_stddev, 0.0);
}

}  // namespace
}  // namespace alignability
