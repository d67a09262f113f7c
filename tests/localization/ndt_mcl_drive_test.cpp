// SPDX-License-Identifier: BSD-3-Clause
// NDT-MCL on simulated scans: it holds in a rich room, and drifts as its odometry does in a plain corridor.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "localization/ndt_mcl.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability {
namespace {

using test::box;

std::vector<TriangleMesh> rich_room() {
  return {box({-1.0, -1.0, -0.1}, {13.0, 9.0, 0.0}), box({-0.2, 0.0, 0.0}, {0.0, 8.0, 3.0}), box({12.0, 0.0, 0.0}, {12.2, 8.0, 3.0}),
          box({0.0, -0.2, 0.0}, {12.0, 0.0, 3.0}),   box({0.0, 8.0, 0.0}, {12.0, 8.2, 3.0}), box({5.0, 3.5, 0.0}, {7.0, 4.5, 2.5}),
          box({2.0, 6.5, 0.0}, {3.0, 7.0, 2.0}),     box({9.0, 0.5, 0.0}, {9.5, 1.5, 2.0})};
}

std::vector<TriangleMesh> corridor() {
  return {box({-40.0, -2.0, -0.1}, {80.0, 2.0, 0.0}), box({-40.0, 1.5, 0.0}, {80.0, 1.7, 3.0}), box({-40.0, -1.7, 0.0}, {80.0, -1.5, 3.0})};
}

// Coarse enough to be quick, with the mount and the noise of a real one.
LidarModel lidar() {
  LidarModel model = test::hdl32e();
  model.columns = 720;
  return model;
}

// A site, and the map that noiseless scans all over it make: of surfaces as they are seen, not of walls' far sides.
struct Site {
  Site(std::vector<TriangleMesh> meshes, const std::vector<Pose2>& surveyed) : scene(std::move(meshes)) {
    std::vector<Eigen::Vector3f> points;
    for (const Pose2& pose : surveyed) {
      const Eigen::Isometry3f T = T_map_base(pose).cast<float>();
      for (const Eigen::Vector3f& point : points_from(pose, std::nullopt)) points.push_back(T * point);
    }
    map = std::make_shared<const Ndt>(points, NdtOptions{});
  }

  static Eigen::Isometry3d T_map_base(const Pose2& pose) {
    return Eigen::Translation3d(pose.x, pose.y, 0.0) * Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ());
  }

  // In the frame of base_link.
  std::vector<Eigen::Vector3f> points_from(const Pose2& pose, std::optional<NoiseKey> noise) const {
    Scan scan = simulate_scan(scene, model, T_map_base(pose) * model.T_base_lidar, {.range_max = 6.5}, noise);
    const Eigen::Isometry3f T_base_lidar = model.T_base_lidar.cast<float>();
    for (Eigen::Vector3f& point : scan.points) point = T_base_lidar * point;
    return scan.points;
  }

  Ndt seen_from(const Pose2& pose, std::uint64_t number) const {
    return {points_from(pose, NoiseKey{.seed = 1, .cell = number, .sample = 0}), {}};
  }

  Scene scene;
  LidarModel model = lidar();
  std::shared_ptr<const Ndt> map;
};

Site rich_site() {
  std::vector<Pose2> surveyed;
  for (const double x : {1.0, 4.0, 8.0, 11.0}) {
    for (const double y : {1.5, 5.5, 7.5}) surveyed.push_back({x, y, 0.0});
  }
  return {rich_room(), surveyed};
}

Site plain_site() {
  std::vector<Pose2> surveyed;
  for (int x = -10; x < 40; ++x) surveyed.push_back({static_cast<double>(x), 0.0, 0.0});
  return {corridor(), surveyed};
}

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

class Localizes : public testing::TestWithParam<CellCombination> {};

TEST_P(Localizes, FromHalfAMetreOffInARichRoomAndStays) {
  const Site site = rich_site();
  Pose2 truth{4.0, 2.0, 0.0};
  NdtMcl mcl(site.map, {4.35, 1.65, radians(2)}, {0.3, 0.3, radians(2)}, {.combination = GetParam()}, 1);
  double sum = 0.0;
  int late = 0;
  for (std::uint64_t step = 0; step < 206; ++step) {
    // Around the block: 4 m ahead, half a turn of 2 m radius, and again.
    const Pose2 motion{0.1, 0.0, step % 103 < 40 ? 0.0 : std::numbers::pi / 63.0};
    truth = moved(truth, motion);
    mcl.move({1.02 * motion.x, 0.0, motion.yaw});
    mcl.see(site.seen_from(truth, step));
    if (step < 40) continue;
    sum += distance(mcl.estimate(), truth);
    ++late;
  }
  // The sum is flat: it holds, not tightly.
  EXPECT_LT(sum / late, GetParam() == CellCombination::sum ? 0.1 : 0.05);
}

TEST_P(Localizes, AcrossAPlainCorridorButNotAlong) {
  const Site site = plain_site();
  Pose2 truth{0.0, 0.2, 0.0};
  constexpr double kBias = 0.05;
  NdtMcl mcl(site.map, truth, {0.02, 0.02, radians(0.5)}, {.combination = GetParam()}, 1);
  for (std::uint64_t step = 0; step < 80; ++step) {
    truth = moved(truth, {0.25, 0.0, 0.0});
    mcl.move({(1.0 + kBias) * 0.25, 0.0, 0.0});
    mcl.see(site.seen_from(truth, step));
  }
  const Pose2 estimate = mcl.estimate();
  EXPECT_LT(std::abs(estimate.y - truth.y), 0.1);
  EXPECT_GT(std::abs(estimate.x - truth.x), 0.3) << "20 m at 5 % bias lead a metre astray, and little holds it back";
}

TEST_P(Localizes, AlikeWithTheSameSeed) {
  const Site site = rich_site();
  const auto estimate = [&](std::uint64_t seed) {
    NdtMcl mcl(site.map, {2.1, 2.0, 0.0}, {0.2, 0.2, 0.05}, {.combination = GetParam()}, seed);
    for (std::uint64_t step = 0; step < 5; ++step) {
      mcl.move({0.1, 0.0, 0.0});
      mcl.see(site.seen_from({2.1 + 0.1 * static_cast<double>(step), 2.0, 0.0}, step));
    }
    return mcl.estimate();
  };
  EXPECT_EQ(estimate(1), estimate(1));
  EXPECT_NE(estimate(1), estimate(2));
}

TEST_P(Localizes, BadlyButFinitelyOnAWrongMap) {
  const Site site = rich_site();
  const Site elsewhere = plain_site();
  NdtMcl mcl(elsewhere.map, {2.0, 2.0, 0.0}, {0.2, 0.2, 0.05}, {.combination = GetParam()}, 1);
  for (std::uint64_t step = 0; step < 20; ++step) {
    mcl.move({0.1, 0.0, 0.05});
    mcl.see(site.seen_from({2.0, 2.0, 0.0}, step));
  }
  EXPECT_TRUE(mcl.estimate().position().allFinite());
}

INSTANTIATE_TEST_SUITE_P(Combination, Localizes, testing::Values(CellCombination::sum, CellCombination::product),
                         [](const auto& instance) { return instance.param == CellCombination::sum ? "Sum" : "Product"; });

}  // namespace
}  // namespace alignability
