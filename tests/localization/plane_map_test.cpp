// SPDX-License-Identifier: BSD-3-Clause
#include "localization/plane_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace alignability {
namespace {

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  Eigen::Vector3f point(float extent) { return {(*this)(-extent, extent), (*this)(-extent, extent), (*this)(-extent, extent)}; }

 private:
  std::mt19937_64 engine_;
};

// Two walls that meet, one of them slanted, and clutter.
std::vector<Eigen::Vector3f> walls_and_clutter() {
  Uniform uniform(1);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 1500; ++i) {
    const float along = uniform(-2.0f, 2.0f), up = uniform(-2.0f, 2.0f);
    points.emplace_back(along, 1.0f + uniform(-0.01f, 0.01f), up);
    points.emplace_back(1.0f + 0.3f * up, along, up);
  }
  for (int i = 0; i < 500; ++i) points.push_back(uniform.point(2.0f));
  return points;
}

const Eigen::Vector3f& nearest_by_brute_force(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& place) {
  return *std::ranges::min_element(points, {}, [&](const Eigen::Vector3f& point) { return (point - place).squaredNorm(); });
}

// Zero where there is no plane.
Eigen::Vector3d normal_by_brute_force(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& at,
                                      const PlaneMapOptions& options) {
  std::vector<Eigen::Vector3d> near;
  for (const Eigen::Vector3f& point : points) {
    if ((point - at).norm() <= static_cast<float>(options.neighbourhood)) near.push_back(point.cast<double>());
  }
  if (static_cast<int>(near.size()) < options.min_neighbours) return Eigen::Vector3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : near) mean += point / static_cast<double>(near.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : near) covariance += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d values = solver.eigenvalues();
  if (values[0] > options.flatness * values[1] || values[1] < options.flatness * values[2]) return Eigen::Vector3d::Zero();
  return solver.eigenvectors().col(0);
}

TEST(PlaneMap, FindsWhatBruteForceFinds) {
  const std::vector<Eigen::Vector3f> points = walls_and_clutter();
  const PlaneMapOptions options;
  const PlaneMap map(points, options);
  Uniform uniform(2);
  int with = 0, without = 0, beyond = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3f place = uniform.point(3.0f);
    const Eigen::Vector3f& nearest = nearest_by_brute_force(points, place);
    const bool within = (nearest - place).norm() <= static_cast<float>(options.reach);
    const Eigen::Vector3d normal = within ? normal_by_brute_force(points, nearest, options) : Eigen::Vector3d::Zero();
    const Surface* const found = map.nearest(place.cast<double>());
    ++(!within ? beyond : normal.isZero() ? without : with);
    ASSERT_EQ(found != nullptr, !normal.isZero()) << place.transpose();
    if (found == nullptr) continue;
    EXPECT_EQ(found->point, nearest);
    EXPECT_NEAR(std::abs(found->normal.cast<double>().dot(normal)), 1.0, 1e-6);
  }
  EXPECT_GT(with, 100);
  EXPECT_GT(without, 100);
  EXPECT_GT(beyond, 100);
}

TEST(PlaneMap, GivesALineOrTooFewPointsNoPlane) {
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(0.02f * static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_EQ(PlaneMap(line, {}).nearest({0.5, 0.0, 0.0}), nullptr);
  const std::vector<Eigen::Vector3f> few{{0.0f, 0.0f, 0.0f}, {0.1f, 0.0f, 0.0f}, {0.0f, 0.1f, 0.0f}, {0.1f, 0.1f, 0.0f}};
  EXPECT_EQ(PlaneMap(few, {.min_neighbours = 5}).nearest({0.0, 0.0, 0.0}), nullptr);
  EXPECT_NE(PlaneMap(few, {.min_neighbours = 4}).nearest({0.0, 0.0, 0.0}), nullptr);
}

TEST(PlaneMap, TakesWhatIsNotFiniteOrFarAway) {
  std::vector<Eigen::Vector3f> points = walls_and_clutter();
  points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  points.emplace_back(0.0f, std::numeric_limits<float>::infinity(), 0.0f);
  points.emplace_back(1e30f, -1e30f, 0.0f);
  const PlaneMap map(points, {});
  EXPECT_NE(map.nearest({-1.5, 1.0, 1.0}), nullptr);
  EXPECT_EQ(map.nearest({1e300, 0.0, 0.0}), nullptr);
  EXPECT_EQ(map.nearest({std::nan(""), 0.0, 0.0}), nullptr);
  EXPECT_EQ(PlaneMap({}, {}).nearest({0.0, 0.0, 0.0}), nullptr);
}

TEST(PlaneMap, RefusesOptionsOutOfRange) {
  EXPECT_THROW(PlaneMap({}, {.reach = 0.0}), std::invalid_argument);
  EXPECT_THROW(PlaneMap({}, {.neighbourhood = 0.0}), std::invalid_argument);
  EXPECT_THROW(PlaneMap({}, {.reach = 0.1, .neighbourhood = 0.2}), std::invalid_argument);
  EXPECT_THROW(PlaneMap({}, {.min_neighbours = 3}), std::invalid_argument);
  EXPECT_THROW(PlaneMap({}, {.flatness = 1.0}), std::invalid_argument);
  EXPECT_THROW(PlaneMap({}, {.flatness = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace alignability
