// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planar_path.hpp"

#include <limits>

namespace alignability {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The cheapest of the paths that leave out vertices, none further apart than the window.
PlanarPath with_shortcuts(const PlanarPath& path, const PlanarMotion& motion) {
  constexpr std::size_t kWindow = 32;
  constexpr double kRounding = 1e-9;  // of the cost
  std::vector<double> cost(path.size(), kInfinite);
  std::vector<std::size_t> before(path.size(), 0);
  cost[0] = 0.0;
  for (std::size_t to = 1; to < path.size(); ++to) {
    before[to] = to - 1;
    cost[to] = cost[to - 1] + motion.cost(path[to - 1], path[to]);
    // The longest first: as a rule it is the cheapest, and the shorter ones need no check then.
    for (std::size_t from = to > kWindow ? to - kWindow : 0; from + 1 < to; ++from) {
      const double reached = cost[from] + motion.cost(path[from], path[to]);
      // A vertex that brings nothing but rounding is left out, and of shortcuts that are as good one is enough.
      const double worth = before[to] + 1 == to ? 1.0 + kRounding : 1.0 - kRounding;
      if (reached > worth * cost[to] || !motion.is_allowed(path[from], path[to])) continue;
      cost[to] = reached;
      before[to] = from;
    }
  }
  PlanarPath shorter;
  for (std::size_t at = path.size() - 1; at > 0; at = before[at]) shorter.push_back(path[at]);
  shorter.push_back(path.front());
  return {shorter.rbegin(), shorter.rend()};
}

using PathTest = std::function<bool(const PlanarPath&)>;

// Moves a vertex by `step` where that lowers the cost; whether it did.
bool move_vertex(PlanarPath& path, std::size_t i, const PlanarMotion& motion, double step, const PathTest& is_accepted) {
  const Eigen::Vector2d along = (path[i + 1] - path[i - 1]).normalized() * step;
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d from = path[i];
  const double before = motion.cost(path[i - 1], from) + motion.cost(from, path[i + 1]);
  for (const Eigen::Vector2d& by : {across, PlanarPath::value_type(-across), along, PlanarPath::value_type(-along)}) {
    const Eigen::Vector2d to = from + by;
    const double cost = motion.cost(path[i - 1], to) + motion.cost(to, path[i + 1]);
    if (cost >= before - 1e-9 * before || !motion.is_allowed(path[i - 1], to) || !motion.is_allowed(to, path[i + 1])) continue;
    path[i] = to;
    if (is_accepted(path)) return true;
    path[i] = from;
  }
  return false;
}

bool is_allowed(const PlanarPath& path, const PlanarMotion& motion) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!motion.is_allowed(path[i - 1], path[i])) return false;
  }
  return true;
}

}  // namespace

double PlanarMotion::cost(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  return (to - from).norm() + weight * risk->integral({from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0});
}

bool PlanarMotion::is_allowed(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  return clearance->is_clear(from, to, radius) && risk->is_drivable(from, to);
}

PlanarPath refined(PlanarPath path, const PlanarMotion& motion) {
  path = with_shortcuts(path, motion);
  // From coarse to fine, each as fine as the curves of the path may need.
  for (const double spacing : {2.0, 1.0, 0.5, 0.25}) {
    path = subdivided(path, spacing, motion);
    relax(path, motion, 0.25 * spacing, [](const PlanarPath&) { return true; });
    path = with_shortcuts(path, motion);
  }
  return path;
}

void relax(PlanarPath& path, const PlanarMotion& motion, double step, const PathTest& is_accepted) {
  constexpr int kSweeps = 60;
  const double finest = 1e-3 * step;
  std::vector<double> steps(path.size(), step);  // of each vertex, halved where none helps
  bool going_on = true;
  for (int sweep = 0; sweep < kSweeps && going_on; ++sweep) {
    going_on = false;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (steps[i] < finest) continue;
      going_on = true;
      steps[i] *= move_vertex(path, i, motion, steps[i], is_accepted) ? 1.5 : 0.5;
    }
  }
}

PlanarPath subdivided(const PlanarPath& path, double spacing) {
  PlanarPath finer{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d step = path[i] - path[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / spacing)));
    for (int piece = 1; piece < pieces; ++piece) finer.push_back(path[i - 1] + step * piece / pieces);
    finer.push_back(path[i]);
  }
  return finer;
}

PlanarPath subdivided(const PlanarPath& path, double spacing, const PlanarMotion& motion) {
  PlanarPath finer{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PlanarPath pieces = subdivided({path[i - 1], path[i]}, spacing);
    if (is_allowed(pieces, motion)) {
      finer.insert(finer.end(), pieces.begin() + 1, pieces.end());
    } else {
      finer.push_back(path[i]);
    }
  }
  return finer;
}

PlanarPath cut_within(PlanarPath path, double distance) {
  const Eigen::Vector2d end = path.back();
  for (std::size_t i = 0; i < path.size(); ++i) {
    if ((path[i] - end).norm() > distance) continue;
    path.resize(i + 1);
    if (i == 0) return path;
    // The first point of the last segment at that distance.
    const Eigen::Vector2d step = path[i] - path[i - 1];
    const Eigen::Vector2d from_end = path[i - 1] - end;
    const double half_b = from_end.dot(step);
    const double c = from_end.squaredNorm() - distance * distance;
    const double root = std::sqrt(std::max(0.0, half_b * half_b - step.squaredNorm() * c));
    path[i] = path[i - 1] + std::clamp((-half_b - root) / step.squaredNorm(), 0.0, 1.0) * step;
    return path;
  }
  return path;
}

}  // namespace alignability
