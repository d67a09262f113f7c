// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "core/range.hpp"

// PCL's VoxelGrid numbers cubes by 32 bits, and returns all points where they do not do: 8 cm cubes within 100 m are more.
namespace alignability {
namespace {

constexpr int kBits = 21;  // of a cube's number along an axis

struct Keyed {
  std::uint64_t cube;
  std::uint32_t point;
  auto operator<=>(const Keyed&) const = default;
};

}  // namespace

std::vector<Eigen::Vector3f> thinned(std::span<const Eigen::Vector3f> points, double side) {
  if (!kPositive.contains(side)) throw std::invalid_argument("the side of a cube must be greater than 0");
  constexpr double kMost = 1 << (kBits - 1);
  std::vector<Keyed> keyed;
  std::vector<Eigen::Vector3f> far;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const Eigen::Array3d cube = (points[i].cast<double>().array() / side).floor();
    if (!(cube.abs() < kMost).all()) {
      far.push_back(points[i]);
      continue;
    }
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) key = key << kBits | static_cast<std::uint64_t>(cube[axis] + kMost);
    keyed.push_back({key, static_cast<std::uint32_t>(i)});
  }
  std::ranges::sort(keyed);
  std::vector<Eigen::Vector3f> means;
  for (std::size_t begin = 0; begin < keyed.size();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t end = begin;
    for (; end < keyed.size() && keyed[end].cube == keyed[begin].cube; ++end) sum += points[keyed[end].point].cast<double>();
    means.emplace_back((sum / static_cast<double>(end - begin)).cast<float>());
    begin = end;
  }
  means.insert(means.end(), far.begin(), far.end());
  return means;
}

}  // namespace alignability
