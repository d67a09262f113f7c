// SPDX-License-Identifier: BSD-3-Clause
#include "localization/ndt.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace alignability {
namespace {

std::vector<Eigen::Vector3f> random_points(std::size_t count, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(low + Eigen::Vector3f(uniform(engine), uniform(engine), uniform(engine)).cwiseProduct(high - low));
  }
  return points;
}

TEST(Ndt, HasTheMeanAndCovarianceOfEachCell) {
  const std::vector<Eigen::Vector3f> points = random_points(200, {1e4f, -0.4f, 0.0f}, {1e4f + 0.8f, 0.0f, 0.4f});
  const Ndt ndt(points, {.cell = 0.4});
  ASSERT_EQ(ndt.cells().size(), 2u);
  const NdtCell* const cell = ndt.find({1e4 + 0.1, -0.2, 0.2});
  ASSERT_NE(cell, nullptr);
  Eigen::Matrix<double, 3, Eigen::Dynamic> inside(3, 0);
  for (const Eigen::Vector3f& point : points) {
    if (std::floor(static_cast<double>(point.x()) / 0.4) != std::floor((1e4 + 0.1) / 0.4)) continue;
    inside.conservativeResize(3, inside.cols() + 1);
    inside.rightCols<1>() = point.cast<double>();
  }
  const Eigen::Vector3d mean = inside.rowwise().mean();
  const Eigen::Matrix<double, 3, Eigen::Dynamic> centred = inside.colwise() - mean;
  EXPECT_LT((cell->mean - mean).norm(), 1e-9);
  EXPECT_LT((cell->covariance - centred * centred.transpose() / static_cast<double>(inside.cols() - 1)).norm(), 1e-9);
}

TEST(Ndt, MakesFlatCellsAsWideAsAsked) {
  const Ndt ndt(random_points(100, {0.0f, 0.0f, 0.1f}, {0.4f, 0.4f, 0.1f}), {.cell = 0.4, .flattest = 1e-3});
  ASSERT_EQ(ndt.cells().size(), 1u);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(ndt.cells()[0].covariance);
  EXPECT_NEAR(solver.eigenvalues()[0] / solver.eigenvalues()[2], 1e-3, 1e-9);
  EXPECT_GT(std::abs(solver.eigenvectors()(2, 0)), 0.999);
}

TEST(Ndt, LeavesCellsOfFewPointsOrOneEmpty) {
  EXPECT_TRUE(Ndt(random_points(5, {0.0f, 0.0f, 0.0f}, {0.4f, 0.4f, 0.4f}), {.cell = 0.4, .min_points = 6}).cells().empty());
  EXPECT_TRUE(Ndt(std::vector<Eigen::Vector3f>(50, {0.1f, 0.1f, 0.1f}), {}).cells().empty());
  const Ndt empty({}, {});
  EXPECT_EQ(empty.find({0.0, 0.0, 0.0}), nullptr);
}

TEST(Ndt, PassesOverWhatIsNotFiniteAndFindsNothingInfinitelyFar) {
  std::vector<Eigen::Vector3f> points = random_points(50, {0.0f, 0.0f, 0.0f}, {0.4f, 0.4f, 0.4f});
  points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  points.emplace_back(std::numeric_limits<float>::infinity(), 0.0f, 0.0f);
  points.emplace_back(1e30f, 0.0f, 0.0f);
  const Ndt ndt(points, {});
  EXPECT_EQ(ndt.cells().size(), 1u);
  EXPECT_EQ(ndt.find({1e300, 0.0, 0.0}), nullptr);
}

TEST(Ndt, RefusesOptionsOutOfRange) {
  EXPECT_THROW(Ndt({}, {.cell = 0.0}), std::invalid_argument);
  EXPECT_THROW(Ndt({}, {.min_points = 3}), std::invalid_argument);
  EXPECT_THROW(Ndt({}, {.flattest = 0.0}), std::invalid_argument);
  EXPECT_THROW(Ndt({}, {.flattest = 1.5}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
