// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/region_growing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <random>

#include "alignability/normal_kernel.hpp"

namespace alignability::detail {
namespace {

NeighbourGraph random_graph(std::mt19937_64& engine, std::size_t points, int links) {
  std::normal_distribution<float> normal;
  std::uniform_int_distribution<std::int32_t> any(0, static_cast<std::int32_t>(points) - 1);
  NeighbourGraph graph{.normals = {}, .most_links = links, .links = {}, .links_of = std::vector<std::int32_t>(points, links)};
  for (std::size_t i = 0; i < points; ++i) {
    const Eigen::Vector3f n = Eigen::Vector3f(1.0f, 0.1f * normal(engine), 0.1f * normal(engine)).normalized();
    // Few values, so that many are equal.
    graph.normals.push_back({n.x(), n.y(), n.z(), 0.1f * static_cast<float>(any(engine) % 4)});
    for (int k = 0; k < links; ++k) graph.links.push_back(any(engine));
  }
  return graph;
}

// As the paper tells it: a queue, a label a point.
std::vector<std::vector<std::int32_t>> grown_plainly(const NeighbourGraph& graph, const GrowingOptions& options) {
  std::vector<std::int32_t> seeds(graph.normals.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = static_cast<std::int32_t>(i);
  const auto normal = [&](std::int32_t i) { return graph.normals[static_cast<std::size_t>(i)]; };
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
      for (int k = 0; k < graph.most_links; ++k) {
        const std::int32_t to = graph.links[static_cast<std::size_t>(from * graph.most_links + k)];
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
    const NeighbourGraph graph = random_graph(engine, 50 + 20 * static_cast<std::size_t>(round), 3);
    const GrowingOptions options{.cosine = std::cos(0.1f), .curvature = 0.15f, .min_points = 3};
    grower.grow(graph, options);
    std::vector<std::vector<std::int32_t>> segments;
    std::size_t begin = 0;
    for (const std::size_t end : grower.ends()) {
      segments.emplace_back(grower.members().begin() + static_cast<std::ptrdiff_t>(begin),
                            grower.members().begin() + static_cast<std::ptrdiff_t>(end));
      begin = end;
    }
    ASSERT_EQ(segments, grown_plainly(graph, options)) << "in round " << round;
    EXPECT_GT(segments.size(), 1u);
  }
}

TEST(EstimateNormals, AgreesWithEigenOnFlatLongAndRoundNeighbourhoods) {
  constexpr int kPoints = 30;
  std::mt19937_64 engine(2);
  std::normal_distribution<float> normal;
  for (int round = 0; round < 300; ++round) {
    std::array<float, 24 * kPoints> points{};
    std::array<Eigen::Matrix<float, 3, kPoints>, 8> clouds;
    for (std::size_t i = 0; i < 8; ++i) {
      const Eigen::Vector3f widths(0.1f, std::pow(10.0f, -1.0f - static_cast<float>(round % 3)), 0.003f);
      const Eigen::Quaternionf turned = Eigen::Quaternionf(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
      for (int p = 0; p < kPoints; ++p) {
        clouds[i].col(p) = turned * widths.cwiseProduct(Eigen::Vector3f(normal(engine), normal(engine), normal(engine)));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          points[24 * static_cast<std::size_t>(p) + 8 * axis + i] = clouds[i](static_cast<Eigen::Index>(axis), p);
        }
      }
    }
    std::array<float, 24> normals{};
    std::array<float, 8> curvatures{};
    estimate_normals(points.data(), kPoints, normals.data(), curvatures.data());
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
