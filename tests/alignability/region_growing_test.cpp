// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/region_growing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <random>

#include "alignability/normal_kernel.hpp"

namespace alignability::detail {
namespace {

// Whom each point may draw in.
using LinkLists = std::vector<std::vector<std::int32_t>>;

LinkLists random_links(std::mt19937_64& engine, std::size_t points, int links) {
  std::uniform_int_distribution<std::int32_t> any(0, static_cast<std::int32_t>(points) - 1);
  LinkLists lists(points);
  for (auto& list : lists) {
    for (int k = 0; k < links; ++k) list.push_back(any(engine));
    std::ranges::sort(list);
  }
  return lists;
}

std::vector<SurfaceNormal> random_normals(std::mt19937_64& engine, std::size_t points) {
  std::normal_distribution<float> normal;
  std::uniform_int_distribution<int> fourth(0, 3);  // few values, so that many are equal
  std::vector<SurfaceNormal> normals;
  for (std::size_t i = 0; i < points; ++i) {
    const Eigen::Vector3f n = Eigen::Vector3f(1.0f, 0.1f * normal(engine), 0.1f * normal(engine)).normalized();
    normals.push_back({n.x(), n.y(), n.z(), 0.1f * static_cast<float>(fourth(engine))});
  }
  return normals;
}

// The same as words of bits, each point in another lane.
NeighbourGraph graph_of(std::vector<SurfaceNormal> normals, const LinkLists& lists) {
  const std::size_t blocks = (lists.size() + 7) / 8;
  NeighbourGraph graph{
      .points = std::vector<std::uint8_t>(blocks + 1, 0), .normals = std::move(normals), .links = {}, .blocks = {}, .bits = {}};
  graph.normals.resize(8 * blocks);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    graph.points[i / 8] |= static_cast<std::uint8_t>(1U << i % 8);
    const auto lane = static_cast<std::uint32_t>(i % 8);
    graph.links.push_back({static_cast<std::uint32_t>(graph.bits.size() / 8), static_cast<std::uint32_t>((lists[i].size() + 3) / 4), lane});
    for (std::size_t k = 0; k < lists[i].size(); ++k) {
      if (k % 4 == 0) graph.bits.resize(graph.bits.size() + 8);
      graph.blocks.push_back(lists[i][k] / 8);
      graph.bits[graph.bits.size() - 8 + lane] |= 1U << (8 * (k % 4) + static_cast<std::size_t>(lists[i][k]) % 8);
    }
    while (graph.blocks.size() % 4 != 0) graph.blocks.push_back(static_cast<std::int32_t>(blocks));
  }
  return graph;
}

// As the paper tells it: a queue, a label a point.
std::vector<std::vector<std::int32_t>> grown_plainly(const std::vector<SurfaceNormal>& normals, const LinkLists& links,
                                                     const GrowingOptions& options) {
  std::vector<std::int32_t> seeds(normals.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = static_cast<std::int32_t>(i);
  const auto normal = [&](std::int32_t i) { return normals[static_cast<std::size_t>(i)]; };
  std::ranges::stable_sort(seeds, [&](std::int32_t a, std::int32_t b) { return normal(a).curvature < normal(b).curvature; });
  std::vector<bool> taken(seeds.size(), false);
  std::vector<std::vector<std::int32_t>> segments;
  for (const std::int32_t seed : seeds) {
    if (taken[static_cast<std::size_t>(seed)]) continue;
    taken[static_cast<std::size_t>(seed)] = true;
    std::vector<std::int32_t> segment{seed};
    std::deque<std::int32_t> queue{seed};
    while (!queue.empty()) {
      const std::int32_t from = queue.front();
      queue.pop_front();
      for (const std::int32_t to : links[static_cast<std::size_t>(from)]) {
        const float cosine = normal(from).x * normal(to).x + normal(from).y * normal(to).y + normal(from).z * normal(to).z;
        if (taken[static_cast<std::size_t>(to)] || std::abs(cosine) < options.cosine) continue;
        taken[static_cast<std::size_t>(to)] = true;
        segment.push_back(to);
        if (normal(to).curvature <= options.curvature) queue.push_back(to);
      }
    }
    if (segment.size() >= static_cast<std::size_t>(options.min_points)) segments.push_back(segment);
  }
  return segments;
}

TEST(RegionGrower, GrowsWhatAPlainQueueGrows) {
  RegionGrower grower;
  std::mt19937_64 engine(1);
  for (int round = 0; round < 50; ++round) {
    const std::size_t points = 50 + 20 * static_cast<std::size_t>(round);
    const std::vector<SurfaceNormal> normals = random_normals(engine, points);
    const LinkLists links = random_links(engine, points, 3 + round % 4);
    const GrowingOptions options{.cosine = std::cos(0.1f), .curvature = 0.15f, .min_points = 3};
    grower.grow(graph_of(normals, links), options);
    std::vector<std::vector<std::int32_t>> segments;
    std::size_t begin = 0;
    for (const std::size_t end : grower.ends()) {
      segments.emplace_back(grower.members().begin() + static_cast<std::ptrdiff_t>(begin),
                            grower.members().begin() + static_cast<std::ptrdiff_t>(end));
      begin = end;
    }
    ASSERT_EQ(segments, grown_plainly(normals, links, options)) << "in round " << round;
    EXPECT_GT(segments.size(), 1u);
  }
}

TEST(EstimateNormals, AgreesWithEigenOnFlatLongAndRoundNeighbourhoods) {
  constexpr int kPoints = 30;
  std::mt19937_64 engine(2);
  std::normal_distribution<float> normal;
  for (int round = 0; round < 300; ++round) {
    // Four blocks a word, of which the first 30 slots are the neighbourhood of one of the eight.
    std::array<float, 24 * 32> coordinates{};
    std::array<float, 24> centers{};
    std::array<Eigen::Matrix<float, 3, kPoints>, 8> clouds;
    for (std::size_t i = 0; i < 8; ++i) {
      const Eigen::Vector3f widths(0.1f, std::pow(10.0f, -1.0f - static_cast<float>(round % 3)), 0.003f);
      const Eigen::Quaternionf turned = Eigen::Quaternionf(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
      for (int p = 0; p < kPoints; ++p) {
        clouds[i].col(p) = turned * widths.cwiseProduct(Eigen::Vector3f(normal(engine), normal(engine), normal(engine)));
        const std::size_t slot = 32 * i + static_cast<std::size_t>(p);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          coordinates[24 * (slot / 8) + 8 * axis + slot % 8] = clouds[i](static_cast<Eigen::Index>(axis), p);
        }
      }
      for (std::size_t axis = 0; axis < 3; ++axis) centers[8 * axis + i] = clouds[i](static_cast<Eigen::Index>(axis), 0);
    }
    std::array<std::int32_t, 32> blocks{};
    std::iota(blocks.begin(), blocks.end(), 0);
    std::array<std::uint32_t, 64> nearest{};
    for (std::size_t i = 0; i < 8; ++i) nearest[8 * i + i] = (1U << kPoints) - 1;
    std::array<float, 24> normals{};
    std::array<float, 8> curvatures{};
    const EightNeighbourhoods near{coordinates.data(), centers.data(), blocks, nearest, kPoints};
    estimate_normals_portably(near, normals.data(), curvatures.data());
    const auto portable = std::pair(normals, curvatures);
    estimate_normals(near, normals.data(), curvatures.data());
    EXPECT_EQ(std::pair(normals, curvatures), portable) << "to the bit, whatever the processor";
    for (std::size_t i = 0; i < 8; ++i) {
      const Eigen::Matrix<double, 3, kPoints> cloud = clouds[i].cast<double>();
      const Eigen::Matrix<double, 3, kPoints> centred = cloud.colwise() - cloud.rowwise().mean();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred * centred.transpose());
      const Eigen::Vector3d found(normals[i], normals[8 + i], normals[16 + i]);
      const double gap = (solver.eigenvalues()[1] - solver.eigenvalues()[0]) / solver.eigenvalues().sum();
      EXPECT_NEAR(found.norm(), 1.0, 1e-5);
      EXPECT_LT(found.cross(solver.eigenvectors().col(0)).norm() * gap, 1e-5);
      EXPECT_NEAR(curvatures[i], solver.eigenvalues()[0] / solver.eigenvalues().sum(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace alignability::detail
