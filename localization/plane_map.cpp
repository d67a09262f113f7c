// SPDX-License-Identifier: BSD-3-Clause
#include "localization/plane_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/range.hpp"

namespace alignability {
namespace {

// The steps to a cube itself and to those around it, to those that are nearest first.
constexpr std::array<Cube, 27> kStepsAround = [] {
  std::array<Cube, 27> steps{};
  for (int i = 0; i < 27; ++i) steps[static_cast<std::size_t>(i)] = {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
  const auto length2 = [](const Cube& step) { return step.x * step.x + step.y * step.y + step.z * step.z; };
  std::ranges::sort(steps, {}, [&](const Cube& step) { return std::pair(length2(step), step); });
  return steps;
}();

void check(const PlaneMapOptions& options) {
  if (!kPositive.contains(options.reach)) throw std::invalid_argument("the reach of a plane map must be greater than 0");
  if (!kPositive.contains(options.neighbourhood) || options.neighbourhood > options.reach) {
    throw std::invalid_argument("a neighbourhood must be greater than 0 and at most the reach");
  }
  if (options.min_neighbours < 4) throw std::invalid_argument("a plane needs at least 4 points");
  if (!kPositive.contains(options.flatness) || options.flatness >= 1.0) throw std::invalid_argument("flatness must be in (0, 1)");
}

}  // namespace

PlaneMap::PlaneMap(std::span<const Eigen::Vector3f> points, const PlaneMapOptions& options) : reach_(options.reach) {
  check(options);
  std::vector<std::pair<Cube, std::uint32_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) order.emplace_back(cube_of(points[i].cast<double>(), reach_), static_cast<std::uint32_t>(i));
  }
  std::ranges::sort(order);
  for (const auto& [cube, number] : order) {
    const auto here = static_cast<std::uint32_t>(surfaces_.size());
    if (index_.number(cube) == blocks_.size()) blocks_.push_back({here, here});
    blocks_.back().end = here + 1;
    surfaces_.push_back({points[number], Eigen::Vector3f::Zero()});
  }
  for (Surface& surface : surfaces_) surface.normal = normal_at(surface.point, options);
}

std::span<const Surface> PlaneMap::in(const Cube& cube) const {
  const auto number = index_.find(cube);
  if (!number) return {};
  return std::span(surfaces_).subspan(blocks_[*number].begin, blocks_[*number].end - blocks_[*number].begin);
}

// Those points of a place's cube and of the ones around it that may lie within √`within2`: `visit` takes a surface and its squared
// distance, and returns what `within2` is from then on.
template <typename Visit>
void PlaneMap::visit_near(const Eigen::Vector3d& place, float within2, Visit visit) const {
  const Cube cube = cube_of(place, reach_);
  const Eigen::Array3d above = place.array() - reach_ * Eigen::Array3d(cube.x, cube.y, cube.z);
  const Eigen::Array3f to_lower = above.square().cast<float>();
  const Eigen::Array3f to_upper = (reach_ - above).square().cast<float>();
  const auto to_layer = [&](int step, int axis) { return step == 0 ? 0.0f : step < 0 ? to_lower[axis] : to_upper[axis]; };
  const Eigen::Vector3f sought = place.cast<float>();
  for (const Cube& step : kStepsAround) {
    if (to_layer(step.x, 0) + to_layer(step.y, 1) + to_layer(step.z, 2) > within2) continue;
    for (const Surface& surface : in({cube.x + step.x, cube.y + step.y, cube.z + step.z})) {
      within2 = visit(surface, (surface.point - sought).squaredNorm());
    }
  }
}

Eigen::Vector3f PlaneMap::normal_at(const Eigen::Vector3f& point, const PlaneMapOptions& options) const {
  const auto within2 = static_cast<float>(options.neighbourhood * options.neighbourhood);
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  // about the point, whose coordinates may be large
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  int count = 0;
  visit_near(point.cast<double>(), within2, [&](const Surface& surface, float distance2) {
    if (distance2 > within2) return within2;
    const Eigen::Vector3d offset = (surface.point - point).cast<double>();
    first += offset;
    second += offset * offset.transpose();
    ++count;
    return within2;
  });
  if (count < options.min_neighbours) return Eigen::Vector3f::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / count - first * first.transpose() / (count * count));
  const Eigen::Vector3d& values = solver.eigenvalues();  // in increasing order
  const bool is_thin = values[0] <= options.flatness * values[1];
  const bool is_wide = values[1] > 0.0 && values[1] >= options.flatness * values[2];
  return is_thin && is_wide ? Eigen::Vector3f(solver.eigenvectors().col(0).cast<float>()) : Eigen::Vector3f::Zero();
}

const Surface* PlaneMap::nearest(const Eigen::Vector3d& place) const {
  if (!place.allFinite()) return nullptr;
  const Surface* best = nullptr;
  auto least2 = static_cast<float>(reach_ * reach_);
  visit_near(place, least2, [&](const Surface& surface, float distance2) {
    if (distance2 > least2) return least2;
    best = &surface;
    return least2 = distance2;
  });
  return best == nullptr || best->normal.isZero(0.0f) ? nullptr : best;
}

}  // namespace alignability
