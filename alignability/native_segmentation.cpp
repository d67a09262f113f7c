// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "alignability/normal_kernel.hpp"
#include "alignability/segmentation_engines.hpp"

namespace alignability::detail {
namespace {

constexpr std::size_t kLanes = NearestPoints::kQueries;
constexpr std::int32_t kBlock = PointBlocks::kBlock;

// Voters farther apart than this share of their range, squared, lie on other surfaces: they have few neighbours in common.
constexpr float kJump2 = 0.1f * 0.1f;

// How far out of the lidar's xy plane the returns of a level ring may be, as a share of their range: what rounding leaves.
constexpr float kFlat = 1e-4f;

}  // namespace

bool lies_in_xy(const Scan& scan, double range_min) {
  return !scan.organized() && std::ranges::all_of(scan.points, [&](const Eigen::Vector3f& point) {
    return !counts(point, range_min) || std::abs(point.z()) <= kFlat * point.norm();
  });
}

const Segmentation& NativeSegmenter::segment(const Scan& scan, const SegmentationOptions& options) {
  blocks_.assign(scan, options.range_min);
  result_.points = blocks_.points();
  result_.normals.assign(scan.points.size(), Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  result_.members.clear();
  result_.ends.clear();
  const int min_points = options.dimensions == Dimensions::two ? options.min_line_points : options.min_points;
  if (blocks_.points() < static_cast<std::size_t>(std::max(min_points, 3))) return result_;

  const int stride = scan.organized() ? options.stride : 1;
  find_voters(scan, stride);
  estimate(scan, options);
  // From a point to the next noise turns the normal at random, over a stride by as much more as a random walk leads away.
  const double smoothness = std::sqrt(static_cast<double>(stride)) * options.smoothness;
  grower_.grow(graph_, {.cosine = static_cast<float>(std::cos(smoothness)),
                        .curvature = static_cast<float>(options.curvature),
                        .min_points = (min_points + stride - 1) / stride});
  for (const std::int32_t slot : grower_.members()) result_.members.push_back(blocks_.scan_index()[static_cast<std::size_t>(slot)]);
  result_.ends = grower_.ends();
  return result_;
}

void NativeSegmenter::find_voters(const Scan& scan, int stride) {
  const std::vector<std::int32_t>& index = blocks_.scan_index();
  graph_.points.assign(static_cast<std::size_t>(blocks_.blocks()) + 1, 0);
  for (std::size_t slot = 0; slot < index.size(); ++slot) {
    if (index[slot] < 0) continue;
    if (stride == 1 || index[slot] % scan.columns % stride == 0)
      graph_.points[slot / kBlock] |= static_cast<std::uint8_t>(1U << slot % kBlock);
  }
}

// Normals and links of every point that votes.
void NativeSegmenter::estimate(const Scan& scan, const SegmentationOptions& options) {
  graph_.normals.resize(blocks_.scan_index().size());
  graph_.links.resize(blocks_.scan_index().size());
  graph_.blocks.clear();
  graph_.bits.clear();
  nearest_.assign(blocks_);
  Group group;
  const auto point = [&](std::int32_t slot) -> const Eigen::Vector3f& {
    return scan.points[static_cast<std::size_t>(blocks_.scan_index()[static_cast<std::size_t>(slot)])];
  };
  for (std::int32_t block = 0; block < blocks_.blocks(); ++block) {
    for (unsigned voters = graph_.points[static_cast<std::size_t>(block)]; voters != 0; voters &= voters - 1) {
      const std::int32_t slot = kBlock * block + std::countr_zero(voters);
      if (group.size > 0) {
        const Eigen::Vector3f& before = point(group.slots[group.size - 1]);
        if ((point(slot) - before).squaredNorm() > kJump2 * before.squaredNorm()) finish(group, scan, options);
      }
      group.slots[group.size++] = slot;
      if (group.size == kLanes) finish(group, scan, options);
    }
    if (!scan.organized() || options.stride == 1) finish(group, scan, options);
  }
  finish(group, scan, options);
}

void NativeSegmenter::finish(Group& group, const Scan& scan, const SegmentationOptions& options) {
  if (group.size == 0) return;
  const int points = static_cast<int>(blocks_.points());
  const int neighbours = std::min(options.normal_neighbours, points);
  const int links = std::min(options.growing_neighbours, points);
  nearest_.search(group.voters(), std::max(neighbours, links));
  if (links > neighbours) link(group);
  if (links > neighbours) nearest_.narrow(neighbours);
  if (options.dimensions == Dimensions::two) {
    take_line_normals(group, scan);
  } else {
    take_normals(group, scan, neighbours);
  }
  if (links < neighbours) nearest_.narrow(links);
  if (links <= neighbours) link(group);
  group.size = 0;
}

void NativeSegmenter::link(const Group& group) {
  const auto first = static_cast<std::uint32_t>(graph_.bits.size() / kLanes);
  const auto words = static_cast<std::uint32_t>(nearest_.nearest().size() / kLanes);
  graph_.blocks.insert(graph_.blocks.end(), nearest_.blocks().begin(), nearest_.blocks().end());
  graph_.bits.insert(graph_.bits.end(), nearest_.nearest().begin(), nearest_.nearest().end());
  for (std::uint32_t lane = 0; lane < group.size; ++lane) graph_.links[static_cast<std::size_t>(group.slots[lane])] = {first, words, lane};
}

void NativeSegmenter::take_normals(const Group& group, const Scan& scan, int neighbours) {
  std::array<float, 3 * kLanes> normals;
  std::array<float, kLanes> curvatures;
  estimate_normals({.coordinates = blocks_.coordinates().data(),
                    .centers = nearest_.queries().data(),
                    .blocks = nearest_.blocks(),
                    .nearest = nearest_.nearest(),
                    .points = neighbours},
                   normals.data(), curvatures.data());
  for (std::size_t lane = 0; lane < group.size; ++lane) {
    set_normal(group.slots[lane], scan, {normals[lane], normals[kLanes + lane], normals[2 * kLanes + lane]}, curvatures[lane]);
  }
}

// In x and y alone: the axis across which the neighbours lie closest to one line.
void NativeSegmenter::take_line_normals(const Group& group, const Scan& scan) {
  for (std::size_t lane = 0; lane < group.size; ++lane) {
    const auto slot = static_cast<std::size_t>(group.slots[lane]);
    const Eigen::Vector2d center = scan.points[static_cast<std::size_t>(blocks_.scan_index()[slot])].head<2>().cast<double>();
    double count = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (std::size_t word = 0; word < nearest_.nearest().size() / kLanes; ++word) {
      for (std::uint32_t bits = nearest_.nearest()[kLanes * word + lane]; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
        const std::int32_t block = nearest_.blocks()[NearestPoints::kBlocksOfWord * word + bit / kBlock];
        const auto neighbour = static_cast<std::size_t>(blocks_.scan_index()[static_cast<std::size_t>(block) * kBlock + bit % kBlock]);
        const Eigen::Vector2d from_center = scan.points[neighbour].head<2>().cast<double>() - center;
        count += 1.0;
        sum += from_center;
        squares += from_center * from_center.transpose();
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(squares / count - sum * sum.transpose() / (count * count));
    const double trace = solver.eigenvalues().sum();
    const double curvature = trace > 0.0 ? std::max(0.0, solver.eigenvalues()[0]) / trace : 0.0;
    const Eigen::Vector2f normal = solver.eigenvectors().col(0).cast<float>();
    set_normal(group.slots[lane], scan, {normal.x(), normal.y(), 0.0f}, static_cast<float>(curvature));
  }
}

void NativeSegmenter::set_normal(std::int32_t slot, const Scan& scan, Eigen::Vector3f normal, float curvature) {
  const auto i = static_cast<std::size_t>(blocks_.scan_index()[static_cast<std::size_t>(slot)]);
  if (normal.dot(scan.points[i]) > 0.0f) normal = -normal;
  result_.normals[i] = normal;
  graph_.normals[static_cast<std::size_t>(slot)] = {normal.x(), normal.y(), normal.z(), curvature};
}

}  // namespace alignability::detail
