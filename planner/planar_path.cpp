// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planar_path.hpp"

#include "planner/headings.hpp"
#include "planner/shortcuts.hpp"

namespace alignability {
namespace {

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

bool PlanarMotion::is_faced(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  return facing == Facing::ahead && risk->has_headings() && from != to;
}

double PlanarMotion::cost(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const double length = (to - from).norm();
  if (!is_faced(from, to)) return length + weight * risk->least_integral(from, to);
  const auto [begin, end] = facing_ahead(from, to);
  return length + weight * risk->integral(begin, end);
}

bool PlanarMotion::is_allowed(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (!clearance->is_clear(from, to, radius)) return false;
  if (!is_faced(from, to)) return risk->is_drivable(from, to);
  const auto [begin, end] = facing_ahead(from, to);
  return risk->is_drivable_along(begin, end);
}

PlanarPath refined(PlanarPath path, const PlanarMotion& motion, const StopTest& stop) {
  path = with_shortcuts(path, motion);
  // From coarse to fine, each as fine as the curves of the path may need.
  for (const double spacing : {2.0, 1.0, 0.5, 0.25}) {
    if (is_told_to_stop(stop)) break;
    path = subdivided(path, spacing, motion);
    relax(
        path, motion, 0.25 * spacing, [](const PlanarPath&) { return true; }, stop);
    path = with_shortcuts(path, motion);
  }
  return path;
}

void relax(PlanarPath& path, const PlanarMotion& motion, double step, const PathTest& is_accepted, const StopTest& stop) {
  constexpr int kSweeps = 60;
  const double finest = 1e-3 * step;
  std::vector<double> steps(path.size(), step);  // of each vertex, halved where none helps
  bool going_on = true;
  for (int sweep = 0; sweep < kSweeps && going_on; ++sweep) {
    going_on = false;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (steps[i] < finest) continue;
      if (is_told_to_stop(stop)) return;
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
