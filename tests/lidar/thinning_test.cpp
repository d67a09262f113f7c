// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

namespace alignability {
namespace {

std::vector<Eigen::Vector3f> random_points(std::size_t count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<float> uniform(-2.0f, 2.0f);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(uniform(engine), uniform(engine), uniform(engine));
  return points;
}

TEST(Thinned, HasTheMeanOfEachCubeThatHoldsPoints) {
  const std::vector<Eigen::Vector3f> points = random_points(5000);
  std::map<std::tuple<double, double, double>, std::pair<Eigen::Vector3d, int>> cubes;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Array3d cube = (point.cast<double>().array() / 0.3).floor();
    auto& [sum, count] = cubes.try_emplace({cube.x(), cube.y(), cube.z()}, Eigen::Vector3d::Zero(), 0).first->second;
    sum += point.cast<double>();
    ++count;
  }
  const std::vector<Eigen::Vector3f> thin = thinned(points, 0.3);
  ASSERT_EQ(thin.size(), cubes.size());
  std::size_t i = 0;
  for (const auto& [cube, mean] : cubes) EXPECT_LT((thin[i++].cast<double>() - mean.first / mean.second).norm(), 1e-6);
}

TEST(Thinned, DoesNotDependOnTheOrderOfPoints) {
  std::vector<Eigen::Vector3f> points = random_points(2000);
  const std::vector<Eigen::Vector3f> before = thinned(points, 0.5);
  std::ranges::reverse(points);
  const std::vector<Eigen::Vector3f> after = thinned(points, 0.5);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((after[i] - before[i]).norm(), 1e-6f);
}

TEST(Thinned, DropsWhatIsNotFiniteAndKeepsWhatIsTooFarToCount) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points{
      {kNan, 0.0f, 0.0f}, {1e9f, 0.0f, 0.0f}, {1e9f, 0.0f, 0.0f}, {0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}};
  const std::vector<Eigen::Vector3f> thin = thinned(points, 1.0);
  ASSERT_EQ(thin.size(), 3u);
  EXPECT_LT((thin[0] - Eigen::Vector3f::Constant(0.15f)).norm(), 1e-6f);
  EXPECT_EQ(thin[1], points[1]);
}

TEST(Thinned, RefusesCubesWithoutASide) {
  for (const double side : {0.0, -1.0, std::nan("")}) EXPECT_THROW(thinned({}, side), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
