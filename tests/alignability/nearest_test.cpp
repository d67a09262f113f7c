// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "alignability/nearest_kernel.hpp"
#include "alignability/point_blocks.hpp"
#include "tests/alignability/simulated.hpp"

namespace alignability::detail {
namespace {

constexpr int kLanes = PointBlocks::kBlock;

Eigen::Vector3f point_of(const PointBlocks& blocks, std::int32_t slot) {
  const float* place = blocks.coordinates().data() + PointBlocks::place(slot);
  return {place[0], place[kLanes], place[2 * kLanes]};
}

// Sorts all, with none of the search's code. In the list's order.
std::vector<std::int32_t> nearest_of_all(const PointBlocks& blocks, std::int32_t slot, int count) {
  std::vector<std::pair<float, std::int32_t>> all;
  for (std::int32_t other = 0; other < kLanes * blocks.blocks(); ++other) {
    const Eigen::Vector3f apart = point_of(blocks, other) - point_of(blocks, slot);
    all.emplace_back(apart.x() * apart.x() + apart.y() * apart.y() + apart.z() * apart.z(), other);
  }
  std::ranges::partial_sort(all, all.begin() + count);
  std::vector<std::int32_t> nearest;
  for (int i = 0; i < count; ++i) nearest.push_back(all[static_cast<std::size_t>(i)].second);
  std::ranges::sort(nearest);
  return nearest;
}

std::vector<std::int32_t> found_for(const NearestPoints& search, std::size_t query) {
  std::vector<std::int32_t> slots;
  for (std::size_t i = 0; i < search.blocks().size() * kLanes; ++i) {
    const std::uint32_t word = search.nearest()[i / 32 * NearestPoints::kQueries + query];
    if ((word >> i % 32 & 1U) != 0) slots.push_back(kLanes * search.blocks()[i / kLanes] + static_cast<std::int32_t>(i % kLanes));
  }
  std::ranges::sort(slots);
  return slots;
}

// `count` neighbours, then of these the half; eight points at a time from all over the scan, the last ones fewer.
void expect_exact(const Scan& scan, int count) {
  PointBlocks blocks;
  blocks.assign(scan, 0.5);
  NearestPoints search;
  search.assign(blocks);
  std::vector<std::int32_t> slots;
  const int step = std::max(1, blocks.blocks() / 60);
  for (int block = 0; block < blocks.blocks(); block += step) {
    for (std::int32_t slot = kLanes * block; slot < kLanes * (block + 1); ++slot) {
      if (blocks.scan_index()[static_cast<std::size_t>(slot)] >= 0) slots.push_back(slot);
    }
  }
  for (std::size_t first = 0; first < slots.size(); first += NearestPoints::kQueries) {
    const auto group = std::span(slots).subspan(first, std::min<std::size_t>(NearestPoints::kQueries, slots.size() - first));
    search.search(group, count);
    for (const int wanted : {count, (count + 1) / 2}) {
      if (wanted < count) search.narrow(wanted);
      for (std::size_t query = 0; query < group.size(); ++query) {
        ASSERT_EQ(found_for(search, query), nearest_of_all(blocks, group[query], wanted)) << "of slot " << group[query];
      }
    }
  }
}

Scan unorganized(std::vector<Eigen::Vector3f> points) {
  const int columns = static_cast<int>(points.size());
  return {.points = std::move(points), .rings = 1, .columns = columns};
}

TEST(NearestPoints, AreExactInAScanByRings) { expect_exact(test::scan_of(test::plain_corridor(), NoiseKey{.seed = 1}), 30); }

TEST(NearestPoints, AreExactInAScanWithoutOrder) {
  Scan scan = test::scan_of(test::plain_corridor(), NoiseKey{.seed = 1});
  std::mt19937_64 engine(2);
  std::shuffle(scan.points.begin(), scan.points.end(), engine);
  expect_exact(unorganized(scan.points), 30);
}

TEST(NearestPoints, AreExactWhereDensityVariesAThousandfold) {
  std::mt19937_64 engine(3);
  std::normal_distribution<float> normal;
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 3000; ++i) {
    const float spread = std::pow(10.0f, static_cast<float>(i % 4) - 2.0f);
    points.emplace_back(5.0f + spread * normal(engine), spread * normal(engine), spread * normal(engine));
  }
  expect_exact(unorganized(points), 17);
}

TEST(NearestPoints, OfEquallyFarOnesAreTheFirstInTheList) {
  std::vector<Eigen::Vector3f> lattice;
  for (int i = 0; i < 1000; ++i) lattice.emplace_back(3.0f + i % 10, i / 10 % 10, i / 100);
  expect_exact(unorganized(lattice), 30);
  expect_exact({.points = lattice, .rings = 10, .columns = 100}, 30);
}

TEST(NearestPoints, MayBeAllOneAndAllThereAre) {
  expect_exact(unorganized(std::vector<Eigen::Vector3f>(100, {1.0f, 2.0f, 3.0f})), 30);
  expect_exact(unorganized({{1.0f, 0.0f, 0.0f}, {1e6f, 0.0f, 0.0f}, {0.0f, 1e12f, 0.0f}}), 3);
}

TEST(PointBlocks, HoldEveryPointThatCountsOnceInABoxAroundIt) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const bool organized : {true, false}) {
    Scan scan = test::scan_of(test::plain_corridor());
    scan.points[7] = {kNan, 1.0f, 1.0f};
    scan.points[8] = {0.1f, 0.1f, 0.1f};
    scan.points[9] = {1e30f, 0.0f, 0.0f};
    if (!organized) scan = unorganized(scan.points);
    PointBlocks blocks;
    blocks.assign(scan, 0.5);
    std::vector<int> times(scan.points.size(), 0);
    for (std::size_t slot = 0; slot < blocks.scan_index().size(); ++slot) {
      const std::int32_t i = blocks.scan_index()[slot];
      if (i < 0) continue;
      ++times[static_cast<std::size_t>(i)];
      ASSERT_EQ(point_of(blocks, static_cast<std::int32_t>(slot)), scan.points[static_cast<std::size_t>(i)]);
      std::size_t node = slot / kLanes;
      for (const Boxes& level : blocks.levels()) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const float value = scan.points[static_cast<std::size_t>(i)][static_cast<Eigen::Index>(axis)];
          ASSERT_LE(level.low[axis][node], value);
          ASSERT_GE(level.high[axis][node], value);
        }
        node /= PointBlocks::kChildren;
      }
    }
    std::size_t points = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const bool counts = scan.points[i].norm() >= 0.5f && scan.points[i].norm() < 1e15f;
      ASSERT_EQ(times[i], counts ? 1 : 0) << i;
      points += counts ? 1 : 0;
    }
    EXPECT_EQ(blocks.points(), points);
  }
}

TEST(NearestKernel, GivesTheSameOnEveryProcessor) {
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  std::vector<float> coordinates(std::size_t{3} * kLanes * 40);
  for (float& value : coordinates) value = uniform(engine);
  std::vector<std::int32_t> blocks(40);
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = static_cast<std::int32_t>(i);
  std::vector<float> queries(coordinates.begin(), coordinates.begin() + 3 * kLanes);
  const auto run = [&](const NearestKernel& kernel) {
    std::vector<float> distances2(blocks.size() * kLanes * kLanes);
    kernel.distances2(coordinates.data(), blocks.data(), 40, queries.data(), distances2.data());
    std::vector<float> bounds(kLanes, 0.5f);
    std::vector<std::int32_t> found(kLanes);
    std::vector<std::uint32_t> bits(blocks.size() / 4 * kLanes);
    EXPECT_FALSE(kernel.select(distances2.data(), 40 * kLanes, 300, bounds.data(), found.data(), bits.data()));
    EXPECT_TRUE(kernel.select(distances2.data(), 40 * kLanes, 20, bounds.data(), found.data(), bits.data()));
    return std::tuple(distances2, bounds, found, bits);
  };
  const auto portable = run(portable_nearest_kernel());
  EXPECT_EQ(std::get<2>(portable), std::vector<std::int32_t>(kLanes, 20));
  EXPECT_EQ(run(nearest_kernel()), portable);
}

TEST(NearestKernel, FindsTheSameChildrenOnEveryProcessor) {
  constexpr int kChildren = 16;
  constexpr int kNodes = 40;
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<float> place(-10.0f, 10.0f), size(0.0f, 2.0f);
  std::vector<float> low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    for (int child = 0; child < kChildren * kNodes; ++child) {
      low[axis].push_back(place(engine));
      high[axis].push_back(low[axis].back() + size(engine));
    }
  }
  const RawBoxes boxes{{low[0].data(), low[1].data(), low[2].data()}, {high[0].data(), high[1].data(), high[2].data()}};
  std::vector<std::int32_t> nodes(kNodes);
  for (std::int32_t node = 0; node < kNodes; ++node) nodes[static_cast<std::size_t>(node)] = kNodes - 1 - node;
  const RawBox query{{-1.0f, 0.0f, 1.0f}, {1.0f, 0.5f, 4.0f}};
  constexpr float kRadius2 = 25.0f;
  const auto run = [&](const NearestKernel& kernel) {
    std::vector<std::int32_t> near(kChildren * (kNodes + 1));
    near.resize(static_cast<std::size_t>(kernel.near_children(boxes, nodes.data(), kNodes, query, kRadius2, near.data())));
    return near;
  };
  std::vector<std::int32_t> expected;
  for (const std::int32_t node : nodes) {
    for (int child = kChildren * node; child < kChildren * (node + 1); ++child) {
      float distance2 = 0.0f;
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(child);
        const float gap = std::max({0.0f, low[axis][i] - query.high[axis], query.low[axis] - high[axis][i]});
        distance2 += gap * gap;
      }
      if (distance2 <= kRadius2) expected.push_back(child);
    }
  }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_LT(expected.size(), 400u);
  EXPECT_EQ(run(portable_nearest_kernel()), expected);
  EXPECT_EQ(run(nearest_kernel()), expected);
}

}  // namespace
}  // namespace alignability::detail
