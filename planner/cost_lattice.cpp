// SPDX-License-Identifier: BSD-3-Clause
#include "planner/cost_lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>

#include "planner/bucket_queue.hpp"

namespace alignability {
namespace {

constexpr std::size_t kBetweenLooks = 4096;  // nodes: less than a millisecond
constexpr float kNowhere = std::numeric_limits<float>::infinity();

// Shares in (0,1) of each cell along an axis at which lines run through the nodes of some risk, where that has its kinks.
std::vector<std::vector<double>> kinks_in_cells(const GridGeometry& lattice, const RiskField& risk, int axis) {
  constexpr double kOnTheLine = 1e-9;
  std::vector<std::vector<double>> kinks(static_cast<std::size_t>(axis == 0 ? lattice.width : lattice.height));
  for (const RiskLayer& layer : risk.layers()) {
    if (layer.weight == 0.0) continue;
    const GridGeometry& nodes = layer.risk.nodes().geometry();
    for (int node = 0; node < (axis == 0 ? nodes.width : nodes.height); ++node) {
      const double at = (nodes.center({node, node})[axis] - lattice.origin[axis]) / lattice.resolution;
      const double cell = std::floor(at);
      if (cell < 0.0 || cell >= static_cast<double>(kinks.size()) || at - cell < kOnTheLine || cell + 1.0 - at < kOnTheLine) continue;
      kinks[static_cast<std::size_t>(cell)].push_back(at - cell);
    }
  }
  for (auto& shares : kinks) {
    if (shares.empty()) continue;
    shares.insert(shares.end(), {0.0, 1.0});
    std::ranges::sort(shares);
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  }
  return kinks;
}

// Both are bilinear between the kinks of all risks, so that one is above the other where it is at their crossings.
double least_share(const RiskField& risk, double weight, const Eigen::AlignedBox2d& cell, std::span<const double> columns,
                   std::span<const double> rows) {
  constexpr double kBothSides[] = {0.0, 1.0};
  if (columns.empty()) columns = kBothSides;
  if (rows.empty()) rows = kBothSides;
  const auto cost = [&](double x, double y) {
    const Eigen::Vector2d at = cell.min() + Eigen::Vector2d(x, y).cwiseProduct(cell.sizes());
    return 1.0 + weight * risk.least_risk(at);
  };
  const double low_left = cost(0.0, 0.0), low_right = cost(1.0, 0.0), high_left = cost(0.0, 1.0), high_right = cost(1.0, 1.0);
  double share = 1.0;
  for (const double y : rows) {
    for (const double x : columns) {
      const double bilinear = (1.0 - y) * ((1.0 - x) * low_left + x * low_right) + y * ((1.0 - x) * high_left + x * high_right);
      share = std::min(share, cost(x, y) / bilinear);
    }
  }
  return share;
}

// False only if no point of a square within which the map's cells are `blocked` can be driven on. Where α-cells are smaller than the
// square, nothing is said.
bool may_be_drivable(const RiskField& risk, const Eigen::AlignedBox2d& cell) {
  if (risk.options().unknown != UnknownPolicy::blocked) return true;
  if (risk.alpha_layer().nodes().geometry().resolution < cell.sizes().x()) return true;
  for (const auto corner :
       {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight, Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    // A hair to either side: the cell's edge may be that of an α-cell.
    for (const double side : {-1e-9, 1e-9}) {
      if (risk.is_drivable(cell.corner(corner) + side * (cell.corner(corner) - cell.center()))) return true;
    }
  }
  return false;
}

GridGeometry ringed(const GridGeometry& map) {
  return {.resolution = map.resolution, .origin = map.corner({-1, -1}), .width = map.width + 3, .height = map.height + 3};
}

}  // namespace

CostLattice::CostLattice(const RiskField& risk, const ClearanceMap& clearance, double weight, double radius, const StopTest& stop)
    : geometry(ringed(clearance.geometry())), cost(geometry.size(), kNowhere), share(geometry.size(), 0.0f) {
  const GridGeometry& map = clearance.geometry();
  const double reach = map.resolution / std::numbers::sqrt2 + 1e-6 * map.resolution;
  const auto columns = kinks_in_cells(geometry, risk, 0);
  const auto rows = kinks_in_cells(geometry, risk, 1);
  for (int y = 1; y <= map.height; ++y) {
    stop_if(stop);
    for (int x = 1; x <= map.width; ++x) {
      const Cell in_map{x - 1, y - 1};
      if (!clearance.is_free(in_map) || clearance.distance_at(in_map) + reach < radius) continue;
      const Eigen::AlignedBox2d square(geometry.corner({x, y}), geometry.corner({x + 1, y + 1}));
      if (!may_be_drivable(risk, square)) continue;
      const auto& kinks_x = columns[static_cast<std::size_t>(x)];
      const auto& kinks_y = rows[static_cast<std::size_t>(y)];
      share[geometry.index({x, y})] =
          kinks_x.empty() && kinks_y.empty() ? 1.0f : static_cast<float>(least_share(risk, weight, square, kinks_x, kinks_y));
      for (const Cell node : {Cell{x, y}, Cell{x + 1, y}, Cell{x, y + 1}, Cell{x + 1, y + 1}}) {
        float& at = cost[geometry.index(node)];
        if (at != kNowhere) continue;
        const Eigen::Vector2d corner = geometry.corner(node);
        at = static_cast<float>(1.0 + weight * risk.least_risk(corner));
      }
    }
  }
}

std::vector<float> drivable_costs(const CostLattice& lattice, const RiskField& risk, const ClearanceMap& clearance, double radius,
                                  const StopTest& stop) {
  std::vector<float> cost = lattice.cost;
  for (std::size_t node = 0; node < cost.size(); ++node) {
    if (node % kBetweenLooks == 0) stop_if(stop);
    if (cost[node] == kNowhere) continue;
    const Eigen::Vector2d at = lattice.geometry.corner(lattice.geometry.cell_of(node));
    if (!clearance.is_clear(at, radius) || !risk.is_drivable(at)) cost[node] = kNowhere;
  }
  return cost;
}

double dearest(std::span<const float> cost) {
  float most = 1.0f;
  for (const float here : cost) most = std::max(most, here == kNowhere ? 1.0f : here);
  return static_cast<double>(most);
}

std::vector<double> fast_marching(const GridGeometry& geometry, std::span<const float> cost, std::span<const MarchingSeed> seeds,
                                  const StopTest& stop) {
  return fast_marching(geometry, cost, seeds, 0, {}, stop);
}

std::vector<double> fast_marching(const GridGeometry& geometry, std::span<const float> cost, std::span<const MarchingSeed> seeds,
                                  std::size_t more, std::span<const MarchingLink> links, const StopTest& stop) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const double step = geometry.resolution;
  const auto row = static_cast<std::size_t>(geometry.width);
  const std::size_t nodes = geometry.size() + more;
  double longest = step * dearest(cost);
  std::vector<bool> is_linked(nodes, false);
  for (const MarchingLink& link : links) {
    longest = std::max(longest, link.cost);
    is_linked[link.from] = true;
  }
  double latest_seed = 0.0;
  for (const MarchingSeed& seed : seeds) latest_seed = std::max(latest_seed, seed.cost);
  // Half a step is never more than what one node adds to another, so that none is visited twice, unless buckets were too many.
  detail::BucketQueue queue(nodes, std::max(0.5 * step, longest / 256.0), std::max(longest, latest_seed));
  std::vector<double> to(nodes, kInfinite);
  for (const MarchingSeed& seed : seeds) {
    if (seed.cost >= to[seed.node]) continue;
    to[seed.node] = seed.cost;
    queue.push(seed.node, seed.cost);
  }
  const auto update = [&](std::size_t node) {
    if (cost[node] == kNowhere) return;
    const double across = std::min(to[node - 1], to[node + 1]);
    const double along = std::min(to[node - row], to[node + row]);
    const double added = step * cost[node];
    const double apart = across - along;
    const double reached =
        std::abs(apart) < added ? 0.5 * (across + along + std::sqrt(2.0 * added * added - apart * apart)) : std::min(across, along) + added;
    if (reached >= to[node]) return;
    to[node] = reached;
    queue.push(node, reached);
  };
  const auto follow_links = [&](std::size_t node) {
    for (const MarchingLink& link : std::ranges::equal_range(links, node, {}, &MarchingLink::from)) {
      const double reached = to[node] + link.cost;
      if (reached >= to[link.to]) continue;
      to[link.to] = reached;
      queue.push(link.to, reached);
    }
  };
  std::size_t visited = 0;
  queue.drain([&](std::size_t node) {
    if (visited++ % kBetweenLooks == 0) stop_if(stop);
    if (is_linked[node]) follow_links(node);
    if (node >= geometry.size()) return;
    for (const std::size_t next : {node - 1, node + 1, node - row, node + row}) {
      if (to[next] > to[node]) update(next);
    }
  });
  return to;
}

}  // namespace alignability
