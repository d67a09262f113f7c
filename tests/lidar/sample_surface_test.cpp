// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sample_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

TEST(SampleSurface, SpreadsPointsEvenlyOverAllFacesThatAreSeen) {
  const PointCloud cloud = sample_surface({make_box({2, 2, 2})}, {.spacing = 0.1});
  EXPECT_NEAR(static_cast<double>(cloud.points.size()), 2000.0, 10.0) << "ten triangles, each rounded at random";
  std::array<int, 6> of_face{};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    EXPECT_NEAR(cloud.points[i].cwiseAbs().maxCoeff(), 1.0f, 1e-6f);
    EXPECT_NEAR(cloud.normals[i].dot(cloud.points[i]), 1.0f, 1e-5f) << "outwards";
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(cloud.normals[i][axis]) > 0.5f) ++of_face[static_cast<std::size_t>(2 * axis + (cloud.normals[i][axis] > 0 ? 1 : 0))];
    }
  }
  EXPECT_EQ(of_face[4], 0) << "there is nothing to look up from";
  of_face[4] = 400;
  for (const int count : of_face) EXPECT_NEAR(count, 400, 2);
}

TEST(SampleSurface, WhatStandsOnAFloorHidesTheFloorBeneath) {
  const auto floor = make_rectangle(4, 4);
  const auto pillar = transformed(make_box({1, 1, 2}), Eigen::Affine3d(Eigen::Translation3d(0, 0, 1)));
  for (const Eigen::Vector3f& point : sample_surface({floor, pillar}, {.spacing = 0.05}).points) {
    EXPECT_FALSE(std::abs(point.x()) < 0.499f && std::abs(point.y()) < 0.499f && point.z() < 1.9f) << point.transpose();
  }
}

TEST(SampleSurface, AShelfAboveAFloorIsSeenFromBelow) {
  const auto shelf = transformed(make_box({1, 1, 0.1}), Eigen::Affine3d(Eigen::Translation3d(0, 0, 1.05)));
  const PointCloud cloud = sample_surface({make_rectangle(4, 4), shelf}, {.spacing = 0.05});
  const auto beneath = std::ranges::count_if(cloud.points, [](const Eigen::Vector3f& point) { return std::abs(point.z() - 1.0f) < 1e-5f; });
  EXPECT_NEAR(static_cast<double>(beneath), 400.0, 2.0);
}

TEST(SampleSurface, NoiseIsAcrossTheSurface) {
  const PointCloud cloud = sample_surface({make_rectangle(10, 10)}, {.spacing = 0.1, .stddev = 0.02});
  double squares = 0.0;
  for (const Eigen::Vector3f& point : cloud.points) {
    squares += point.z() * point.z();
    EXPECT_LE(std::max(std::abs(point.x()), std::abs(point.y())), 5.0f);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(cloud.points.size())), 0.02, 0.001);
}

TEST(SampleSurface, TheSeedSaysWherePointsLie) {
  const std::vector<TriangleMesh> box{make_box({1, 1, 1})};
  EXPECT_EQ(sample_surface(box, {.seed = 3}).points, sample_surface(box, {.seed = 3}).points);
  EXPECT_NE(sample_surface(box, {.seed = 3}).points, sample_surface(box, {.seed = 4}).points);
}

TEST(SampleSurface, OptionsOutOfRangeAndTooManyPointsAreRefused) {
  const std::vector<TriangleMesh> box{make_box({1000, 1000, 1000})};
  for (const SampleOptions& options :
       {SampleOptions{.spacing = 0.0}, {.spacing = std::nan("")}, {.spacing = 0.01}, {.spacing = 10, .stddev = -1.0}}) {
    EXPECT_THROW(sample_surface(box, options), std::invalid_argument);
  }
}

}  // namespace
}  // namespace alignability
