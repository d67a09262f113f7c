// SPDX-License-Identifier: BSD-3-Clause
#include "planner/cost_bound.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "planner/bucket_queue.hpp"

namespace alignability {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr float kNoLimit = std::numeric_limits<float>::infinity();

struct Corners {
  double low_left, low_right, high_left, high_right;
};

template <typename T>
Corners corners(const std::vector<T>& values, std::size_t cell, std::size_t row) {
  return {static_cast<double>(values[cell]), static_cast<double>(values[cell + 1]), static_cast<double>(values[cell + row]),
          static_cast<double>(values[cell + row + 1])};
}

// An edge's value at its share t is linear but for this times t² - t, which makes it grow in proportion to the cost.
double bend(double from, double to, double cost_from, double cost_to) {
  return (to - from) * (cost_to - cost_from) / (cost_to + cost_from);
}

// What an edge is given at least of what its cost allows. Wherever L hardly grows along an edge, this keeps Dijkstra's ways from changing
// over for nothing to where the cells' factors are smallest.
constexpr double kLeast = 0.1;

// A length that cost allows [equivalent m].
double allowed(double cost_from, double cost_to, double resolution) { return 0.5 * (cost_from + cost_to) * resolution; }

// The greatest factor for the lengths of a cell's edges, as `guide` has them, with which L still grows no faster than the cost.
float factor(const Corners& guide, const Corners& cost, double resolution, double share) {
  constexpr double kRounding = 1.0 - 1e-6;  // of costs and factors to float
  const auto slope = [&](double from, double to, double cost_from, double cost_to) {
    return std::max(kLeast, std::abs(to - from) / allowed(cost_from, cost_to, resolution));
  };
  const Eigen::Vector2d steepest(std::max(slope(guide.low_left, guide.low_right, cost.low_left, cost.low_right),
                                          slope(guide.high_left, guide.high_right, cost.high_left, cost.high_right)),
                                 std::max(slope(guide.low_left, guide.high_left, cost.low_left, cost.high_left),
                                          slope(guide.low_right, guide.high_right, cost.low_right, cost.high_right)));
  // L is bent along an edge whose ends differ in cost, and leans across a cell, by up to this, whose opposite edges are bent differently.
  const double least = std::min({cost.low_left, cost.low_right, cost.high_left, cost.high_right});
  const Eigen::Vector2d bent(std::abs(cost.low_right - cost.low_left) + std::abs(cost.high_right - cost.high_left),
                             std::abs(cost.high_left - cost.low_left) + std::abs(cost.high_right - cost.low_right));
  const Eigen::Vector2d lean(steepest.y() * bent.y() / (8.0 * least), steepest.x() * bent.x() / (8.0 * least));
  return static_cast<float>(kRounding * share / (steepest + lean).norm());
}

// No limit from cells that are not open.
std::vector<float> factors(const CostLattice& lattice, const std::vector<double>& guide) {
  const auto row = static_cast<std::size_t>(lattice.geometry.width);
  std::vector<float> all(lattice.geometry.size(), kNoLimit);
  for (std::size_t cell = 0; cell < all.size(); ++cell) {
    if (!lattice.is_open(cell) || guide[cell] == kInfinite) continue;
    all[cell] = factor(corners(guide, cell, row), corners(lattice.cost, cell, row), lattice.geometry.resolution,
                       static_cast<double>(lattice.share[cell]));
  }
  return all;
}

// The least that the edges' lengths add up to from the seeds.
std::vector<double> shortest_ways(const CostLattice& lattice, const std::vector<double>& guide, std::span<const MarchingSeed> seeds) {
  const std::vector<float> factor = factors(lattice, guide);
  const double resolution = lattice.geometry.resolution;
  const auto row = static_cast<std::size_t>(lattice.geometry.width);
  std::vector<double> way(guide.size(), kInfinite);
  // As long as any edge may be.
  const double longest = resolution * dearest(lattice.cost) / kLeast;
  detail::BucketQueue queue(way.size(), std::max(0.5 * resolution, longest / 1024.0), longest);
  for (const MarchingSeed& seed : seeds) {
    way[seed.node] = seed.cost;
    queue.push(seed.node, seed.cost);
  }
  const auto improve = [&](std::size_t from, std::size_t to, float limit) {
    if (limit == kNoLimit) return;
    const double length = std::max(std::abs(guide[to] - guide[from]), kLeast * allowed(static_cast<double>(lattice.cost[from]),
                                                                                       static_cast<double>(lattice.cost[to]), resolution));
    const double reached = way[from] + static_cast<double>(limit) * length;
    if (reached >= way[to]) return;
    way[to] = reached;
    queue.push(to, reached);
  };
  queue.drain([&](std::size_t node) {
    const float high_right = factor[node];
    const float high_left = factor[node - 1];
    const float low_right = factor[node - row];
    const float low_left = factor[node - row - 1];
    improve(node, node + 1, std::min(high_right, low_right));
    improve(node, node - 1, std::min(high_left, low_left));
    improve(node, node + row, std::min(high_right, high_left));
    improve(node, node - row, std::min(low_right, low_left));
  });
  return way;
}

// All corners of the open cells that a disk meets.
std::vector<MarchingSeed> corners_around(const CostLattice& lattice, const Eigen::Vector2d& place, double radius) {
  const GridGeometry& grid = lattice.geometry;
  const Eigen::Array2d low = ((place - grid.origin).array() - radius) / grid.resolution - 1.0;
  const Eigen::Array2d high = ((place - grid.origin).array() + radius) / grid.resolution + 1.0;
  std::vector<MarchingSeed> seeds;
  for (int y = static_cast<int>(std::max(1.0, low.y())); y <= std::min(grid.height - 2.0, high.y()); ++y) {
    for (int x = static_cast<int>(std::max(1.0, low.x())); x <= std::min(grid.width - 2.0, high.x()); ++x) {
      const Eigen::AlignedBox2d square(grid.corner({x, y}), grid.corner({x + 1, y + 1}));
      if (!lattice.is_open(grid.index({x, y})) || square.exteriorDistance(place) > radius) continue;
      for (const Cell node : {Cell{x, y}, Cell{x + 1, y}, Cell{x, y + 1}, Cell{x + 1, y + 1}}) seeds.push_back({grid.index(node), 0.0});
    }
  }
  return seeds;
}

}  // namespace

CostBound::CostBound(std::shared_ptr<const CostLattice> lattice, const Eigen::Vector2d& place, double tolerance)
    : lattice_(std::move(lattice)) {
  const std::vector<MarchingSeed> seeds = corners_around(*lattice_, place, tolerance);
  at_node_ = fast_marching(lattice_->geometry, lattice_->cost, seeds);
  // The second round is guided by the first one's result and takes up what that left unused.
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) at_node_ = shortest_ways(*lattice_, at_node_, seeds);
}

double CostBound::operator()(const Eigen::Vector2d& point) const {
  const GridGeometry& grid = lattice_->geometry;
  const auto cell = grid.cell_near(point);
  if (!cell || !lattice_->is_open(grid.index(*cell))) return kInfinite;
  const auto row = static_cast<std::size_t>(grid.width);
  const Corners value = corners(at_node_, grid.index(*cell), row);
  if (value.low_left == kInfinite) return kInfinite;
  const Corners cost = corners(lattice_->cost, grid.index(*cell), row);
  const Eigen::Vector2d at = (point - grid.corner(*cell)) / grid.resolution;
  const auto on_edge = [](double t, double from, double to, double cost_from, double cost_to) {
    return bend(from, to, cost_from, cost_to) * (t * t - t);
  };
  const double below = value.low_left + at.x() * (value.low_right - value.low_left);
  const double above = value.high_left + at.x() * (value.high_right - value.high_left);
  return below + at.y() * (above - below) +
         (1.0 - at.y()) * on_edge(at.x(), value.low_left, value.low_right, cost.low_left, cost.low_right) +
         at.y() * on_edge(at.x(), value.high_left, value.high_right, cost.high_left, cost.high_right) +
         (1.0 - at.x()) * on_edge(at.y(), value.low_left, value.high_left, cost.low_left, cost.high_left) +
         at.x() * on_edge(at.y(), value.low_right, value.high_right, cost.low_right, cost.high_right);
}

double CostBound::dip(std::size_t cell) const {
  const auto row = static_cast<std::size_t>(lattice_->geometry.width);
  const Corners value = corners(at_node_, cell, row);
  const Corners cost = corners(lattice_->cost, cell, row);
  const double along_x = std::max({0.0, bend(value.low_left, value.low_right, cost.low_left, cost.low_right),
                                   bend(value.high_left, value.high_right, cost.high_left, cost.high_right)});
  const double along_y = std::max({0.0, bend(value.low_left, value.high_left, cost.low_left, cost.high_left),
                                   bend(value.low_right, value.high_right, cost.low_right, cost.high_right)});
  return 0.25 * (along_x + along_y);
}

double CostBound::least_sum(const CostBound& a, const CostBound& b, std::size_t cell) {
  const auto row = static_cast<std::size_t>(a.lattice_->geometry.width);
  double least = kInfinite;
  for (const std::size_t node : {cell, cell + 1, cell + row, cell + row + 1}) least = std::min(least, a.at_node_[node] + b.at_node_[node]);
  return least == kInfinite ? kInfinite : least - a.dip(cell) - b.dip(cell);
}

}  // namespace alignability
