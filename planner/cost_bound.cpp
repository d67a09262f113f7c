// SPDX-License-Identifier: BSD-3-Clause
#include "planner/cost_bound.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/bucket_queue.hpp"

namespace alignability {
namespace {

using detail::Inside;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr float kNoLimit = std::numeric_limits<float>::infinity();

// What an edge is given at least of what its cost allows. Wherever L hardly grows along an edge, this keeps Dijkstra's ways from changing
// over for nothing to where limits are lowest.
constexpr double kLeast = 0.07;
// How far an edge is bent at most, as a share of what L grows by along it.
constexpr double kMostBent = 0.25;
// A cell along which the guide grows by more than the cost over this share of it stays unbent. In all others no limit falls below 0: lean
// takes at most an eighth of that growth, bending adds at most a quarter to it, and (0.65 − 0.125) / 1.25 of 0.75 is more than 0.25.
constexpr double kRough = 0.65;

// Of a cell, the values at its corners or of its edges.
struct Corners {
  double low_left, low_right, high_left, high_right;
};
struct Edges {
  double below, above, left, right;
};

template <typename T>
Corners corners(const std::vector<T>& values, std::size_t cell, std::size_t row) {
  return {static_cast<double>(values[cell]), static_cast<double>(values[cell + 1]), static_cast<double>(values[cell + row]),
          static_cast<double>(values[cell + row + 1])};
}

Edges growth(const std::vector<double>& guide, std::size_t cell, std::size_t row) {
  const Corners at = corners(guide, cell, row);
  return {at.low_right - at.low_left, at.high_right - at.high_left, at.high_left - at.low_left, at.high_right - at.low_right};
}

// How L is bent along the edges that leave a node to the right and upwards: at the share t it is linear but for this times t² − t.
struct Bends {
  float right = 0.0f;
  float up = 0.0f;
};

Edges bends_of(const std::vector<Bends>& bends, std::size_t cell, std::size_t row) {
  return {bends[cell].right, bends[cell + row].right, bends[cell].up, bends[cell + 1].up};
}

// So that growth changes evenly along the edge as it does from edge to edge; straight where it does not.
float bend_of(const std::vector<double>& guide, std::size_t node, std::size_t step) {
  const double grows = guide[node + step] - guide[node];
  const double change_before = grows - (guide[node] - guide[node - step]);
  const double change_after = guide[node + 2 * step] - guide[node + step] - grows;
  if (!(change_before * change_after > 0.0)) return 0.0f;
  const double change = std::abs(change_before) < std::abs(change_after) ? change_before : change_after;
  const double most = kMostBent * std::abs(grows);
  return static_cast<float>(std::clamp(0.5 * change, -most, most));
}

struct Interpolation {
  std::vector<Bends> bends;
  std::vector<Inside> insides;
};

// How much two edges that meet grow by, as far as limits go by it.
double steepness(double along_x, double along_y, double floor) {
  const double x = std::max(std::abs(along_x), floor);
  const double y = std::max(std::abs(along_y), floor);
  return std::sqrt(x * x + y * y);
}

// A front's kink that runs through a cell is too steep at a corner where its two sides meet, and not within the planes on either side.
Inside inside_of(const Edges& grows, const Corners& cost, double resolution) {
  constexpr double kSteep = 1.1;         // of the cost
  constexpr double kWorthPlanes = 0.95;  // of the blend's steepness
  const double least = std::min({cost.low_left, cost.low_right, cost.high_left, cost.high_right});
  const double floor = kLeast * least * resolution;
  const double low_left = steepness(grows.below, grows.left, floor);
  const double low_right = steepness(grows.below, grows.right, floor);
  const double high_left = steepness(grows.above, grows.left, floor);
  const double high_right = steepness(grows.above, grows.right, floor);
  const double blended =
      std::max({low_left / cost.low_left, low_right / cost.low_right, high_left / cost.high_left, high_right / cost.high_right});
  const double rising = std::max(low_right, high_left) / least;
  const double falling = std::max(low_left, high_right) / least;
  if (blended < kSteep * resolution || std::min(rising, falling) > kWorthPlanes * blended) return Inside::blended;
  return rising < falling ? Inside::rising : Inside::falling;
}

// Whether bending its edges might leave one a limit below 0.
bool is_rough(const Edges& grows, const Corners& cost, double resolution, double share) {
  const auto [least, most] = std::minmax({cost.low_left, cost.low_right, cost.high_left, cost.high_right});
  const double steepest = steepness(std::max(std::abs(grows.below), std::abs(grows.above)),
                                    std::max(std::abs(grows.left), std::abs(grows.right)), kLeast * most * resolution);
  return kRough * steepest > share * least * resolution;
}

Interpolation interpolation_of(const CostLattice& lattice, const std::vector<double>& guide, const StopTest& stop) {
  const auto row = static_cast<std::size_t>(lattice.geometry.width);
  const double resolution = lattice.geometry.resolution;
  Interpolation made{std::vector<Bends>(guide.size()), std::vector<Inside>(guide.size(), Inside::none)};
  for (std::size_t cell = 0; cell < guide.size(); ++cell) {
    if (cell % row == 0) stop_if(stop);
    if (!lattice.is_open(cell) || guide[cell] == kInfinite) continue;
    made.bends[cell] = {bend_of(guide, cell, 1), bend_of(guide, cell, row)};
    made.bends[cell + row].right = bend_of(guide, cell + row, 1);
    made.bends[cell + 1].up = bend_of(guide, cell + 1, row);
  }
  for (std::size_t cell = 0; cell < guide.size(); ++cell) {
    if (cell % row == 0) stop_if(stop);
    if (!lattice.is_open(cell) || guide[cell] == kInfinite) continue;
    const Edges grows = growth(guide, cell, row);
    const Corners cost = corners(lattice.cost, cell, row);
    made.insides[cell] = inside_of(grows, cost, resolution);
    if (made.insides[cell] == Inside::blended && !is_rough(grows, cost, resolution, static_cast<double>(lattice.share[cell]))) continue;
    made.bends[cell] = {};
    made.bends[cell + row].right = 0.0f;
    made.bends[cell + 1].up = 0.0f;
  }
  return made;
}

// By how much L may grow along the edges that leave a node to the right and upwards, and the other way along them. An infinite limit is
// that of an edge of no open cell.
struct Limits {
  float right = kNoLimit;
  float left = kNoLimit;
  float up = kNoLimit;
  float down = kNoLimit;
};

// At an end of an edge L's slope is its growth and `bent`; a slope of up to `slope` either way is within these limits of growth.
void limit(float& forth, float& back, double slope, double bent) {
  constexpr double kRounding = 1.0 - 1e-6;  // of costs and limits to float
  forth = std::min(forth, static_cast<float>(kRounding * (slope - bent)));
  back = std::min(back, static_cast<float>(kRounding * (slope + bent)));
}

// The limits within which L grows no faster than the cost in any open cell, shared between the axes as the guide grows along them.
std::vector<Limits> limits_along(const CostLattice& lattice, const std::vector<double>& guide, const Interpolation& interpolation,
                                 const StopTest& stop) {
  const auto row = static_cast<std::size_t>(lattice.geometry.width);
  const double resolution = lattice.geometry.resolution;
  std::vector<Limits> limits(guide.size());
  for (std::size_t cell = 0; cell < guide.size(); ++cell) {
    if (cell % row == 0) stop_if(stop);
    const Inside inside = interpolation.insides[cell];
    if (inside == Inside::none) continue;
    const Edges grows = growth(guide, cell, row);
    const Edges bent = bends_of(interpolation.bends, cell, row);
    const Corners cost = corners(lattice.cost, cell, row);
    const double allowed = static_cast<double>(lattice.share[cell]) * resolution;
    const double least = std::min({cost.low_left, cost.low_right, cost.high_left, cost.high_right});
    const double lean_x = bent.right - bent.left;
    const double lean_y = bent.above - bent.below;
    const double lean = 0.25 * std::sqrt(lean_x * lean_x + lean_y * lean_y);
    const auto at_corner = [&](double cost_there, double slope_x, double slope_y, double bent_x, double bent_y, Limits& x, Limits& y) {
      const double most = allowed * (inside == Inside::blended ? cost_there : least);
      const double along_x = std::max(std::abs(slope_x + bent_x), kLeast * most);
      const double along_y = std::max(std::abs(slope_y + bent_y), kLeast * most);
      const double scale = (most - lean) / std::sqrt(along_x * along_x + along_y * along_y);
      limit(x.right, x.left, scale * along_x, bent_x);
      limit(y.up, y.down, scale * along_y, bent_y);
    };
    Limits& here = limits[cell];
    if (inside != Inside::rising) {
      at_corner(cost.low_left, grows.below, grows.left, -bent.below, -bent.left, here, here);
      at_corner(cost.high_right, grows.above, grows.right, bent.above, bent.right, limits[cell + row], limits[cell + 1]);
    }
    if (inside != Inside::falling) {
      at_corner(cost.low_right, grows.below, grows.right, bent.below, -bent.right, here, limits[cell + 1]);
      at_corner(cost.high_left, grows.above, grows.left, -bent.above, bent.left, limits[cell + row], here);
    }
  }
  return limits;
}

// The least that the limits along edges add up to from the seeds.
std::vector<double> shortest_ways(const CostLattice& lattice, const std::vector<Limits>& limits, std::span<const MarchingSeed> seeds,
                                  const StopTest& stop) {
  const double resolution = lattice.geometry.resolution;
  const auto row = static_cast<std::size_t>(lattice.geometry.width);
  std::vector<double> way(limits.size(), kInfinite);
  // A limit is at most the cost and a bend.
  const double longest = (1.0 + kMostBent) * resolution * dearest(lattice.cost);
  detail::BucketQueue queue(way.size(), std::max(0.5 * resolution, longest / 1024.0), longest);
  for (const MarchingSeed& seed : seeds) {
    way[seed.node] = seed.cost;
    queue.push(seed.node, seed.cost);
  }
  const auto improve = [&](std::size_t from, std::size_t to, float length) {
    const double reached = way[from] + static_cast<double>(length);
    if (reached >= way[to]) return;
    way[to] = reached;
    queue.push(to, reached);
  };
  std::size_t visited = 0;
  queue.drain([&](std::size_t node) {
    if (visited++ % row == 0) stop_if(stop);
    improve(node, node + 1, limits[node].right);
    improve(node, node - 1, limits[node - 1].left);
    improve(node, node + row, limits[node].up);
    improve(node, node - row, limits[node - row].down);
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

CostBound::CostBound(std::shared_ptr<const CostLattice> lattice, const Eigen::Vector2d& place, double tolerance, const StopTest& stop)
    : lattice_(std::move(lattice)), nodes_(lattice_->geometry.size()) {
  const std::vector<MarchingSeed> seeds = corners_around(*lattice_, place, tolerance);
  const std::vector<double> guide = fast_marching(lattice_->geometry, lattice_->cost, seeds, stop);
  Interpolation interpolation = interpolation_of(*lattice_, guide, stop);
  const std::vector<double> way = shortest_ways(*lattice_, limits_along(*lattice_, guide, interpolation, stop), seeds, stop);
  insides_ = std::move(interpolation.insides);
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    nodes_[node] = {way[node], interpolation.bends[node].right, interpolation.bends[node].up};
  }
}

double CostBound::operator()(const Eigen::Vector2d& point) const {
  const GridGeometry& grid = lattice_->geometry;
  const auto in = grid.cell_near(point);
  if (!in) return kInfinite;
  const std::size_t cell = grid.index(*in);
  if (insides_[cell] == detail::Inside::none) return kInfinite;
  const Node* below = &nodes_[cell];
  const Node* above = below + grid.width;
  const double x = (point.x() - grid.origin.x()) / grid.resolution - in->x;
  const double y = (point.y() - grid.origin.y()) / grid.resolution - in->y;
  const double along_below = below[1].value - below[0].value;
  const double along_above = above[1].value - above[0].value;
  const double along_left = above[0].value - below[0].value;
  const double along_right = above[1].value - below[1].value;
  if (insides_[cell] == detail::Inside::rising) {
    return below[0].value + (y < x ? x * along_below + y * along_right : x * along_above + y * along_left);
  }
  if (insides_[cell] == detail::Inside::falling) {
    return x + y < 1.0 ? below[0].value + x * along_below + y * along_left
                       : above[1].value - (1.0 - x) * along_above - (1.0 - y) * along_right;
  }
  const double bent_x = static_cast<double>(below[0].bend_right) + y * static_cast<double>(above[0].bend_right - below[0].bend_right);
  const double bent_y = static_cast<double>(below[0].bend_up) + x * static_cast<double>(below[1].bend_up - below[0].bend_up);
  return below[0].value + x * along_below + y * (along_left + x * (along_above - along_below)) + (x * x - x) * bent_x +
         (y * y - y) * bent_y;
}

double CostBound::dip(std::size_t cell) const {
  const Node* below = &nodes_[cell];
  const Node* above = below + lattice_->geometry.width;
  return 0.25 * (std::max({0.0f, below[0].bend_right, above[0].bend_right}) + std::max({0.0f, below[0].bend_up, below[1].bend_up}));
}

double CostBound::least_sum(const CostBound& a, const CostBound& b, std::size_t cell) {
  if (a.insides_[cell] == Inside::none || b.insides_[cell] == Inside::none) return kInfinite;
  const auto row = static_cast<std::size_t>(a.lattice_->geometry.width);
  const auto sum = [&](std::size_t node) { return a.nodes_[node].value + b.nodes_[node].value; };
  return std::min({sum(cell), sum(cell + 1), sum(cell + row), sum(cell + row + 1)}) - a.dip(cell) - b.dip(cell);
}

}  // namespace alignability
