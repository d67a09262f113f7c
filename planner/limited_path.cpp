// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_path.hpp"

#include <algorithm>

#include "planner/least_limit.hpp"
#include "planner/limited_search.hpp"

namespace alignability {
namespace {

using detail::LimitedSearch;

constexpr double kSpacings[] = {0.5, 0.25};  // of the places searched, the next one where the last leads nowhere [m]
// States that differ by less than such a share of the limit count as one; the next share where that loses the way.
constexpr double kAlike[] = {0.02, 0.001};

// Up to where the path is within the tolerance of its end.
bool is_kept(const PlanarPath& whole, const PlanarMotion& motion, const PathLimits& limits, double tolerance) {
  const PlanarPath path = cut_within(whole, tolerance);
  std::optional<PathLimits::State> state = limits.at_start();
  for (std::size_t i = 1; state && i < path.size(); ++i) state = limits.after(*state, path[i - 1], path[i], *motion.risk);
  return state.has_value();
}

double cost_of(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += motion.cost(path[i - 1], path[i]);
  return cost;
}

// Leaves out vertices, the longest row of them first, as long as that makes the path no dearer and keeps the limits.
PlanarPath with_shortcuts(PlanarPath path, const PlanarMotion& motion, const PathLimits& limits, double tolerance) {
  constexpr std::size_t kWindow = 32;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    for (std::size_t k = std::min(path.size() - 1, i + kWindow); k > i + 1; --k) {
      const PlanarPath replaced(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (motion.cost(path[i], path[k]) > cost_of(replaced, motion) * (1.0 + 1e-9) || !motion.is_allowed(path[i], path[k])) continue;
      PlanarPath shorter = path;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i) + 1, shorter.begin() + static_cast<std::ptrdiff_t>(k));
      if (!is_kept(shorter, motion, limits, tolerance)) continue;
      path = std::move(shorter);
      break;
    }
  }
  return path;
}

PlanarPath freed(PlanarPath path, const PlanarMotion& motion, const PathLimits& limits, double tolerance, const StopTest& stop) {
  path = with_shortcuts(std::move(path), motion, limits, tolerance);
  for (const double spacing : {2.0, 1.0, 0.5}) {
    if (is_told_to_stop(stop)) break;
    path = subdivided(path, spacing, motion);
    relax(
        path, motion, 0.25 * spacing, [&](const PlanarPath& moved) { return is_kept(moved, motion, limits, tolerance); }, stop);
    path = with_shortcuts(std::move(path), motion, limits, tolerance);
  }
  return path;
}

// More metres than any way can have that is at each place once.
double longest_way(const PlanarMotion& motion) {
  const Eigen::Vector2d extent = motion.clearance->geometry().extent();
  return 3.0 / kSpacings[1] * extent.prod() + 3.0 * extent.sum();
}

}  // namespace

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const PathLimits& limits) { return is_kept(path, motion, limits, 0.0); }

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way, const StopTest& stop) {
  if (limits.error && limits.error->model.least > limits.error->most) return std::nullopt;
  for (const double spacing : kSpacings) {
    const LimitedSearch search(motion, limits, spacing, way, stop);
    const auto any = search.any(limits, kAlike[1]);
    if (!any) continue;
    for (const double alike : kAlike) {
      if (const auto path = search.cheapest(alike)) return freed(*path, motion, limits, way.tolerance, stop);
    }
    return freed(*any, motion, limits, way.tolerance, stop);
  }
  return std::nullopt;
}

std::optional<double> smallest_max_error(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way,
                                         const StopTest& stop) {
  const ErrorModel& model = limits.error->model;
  const LimitedSearch search(motion, limits, kSpacings[1], way, stop);
  const LimitRange range{.least = model.least, .most = model.least + model.growth * longest_way(motion)};
  const auto does = [&](double most) {
    PathLimits tried = limits;
    tried.error->most = most;
    return search.any(tried, kAlike[1]).has_value();
  };
  return least_limit(range, does, stop);
}

std::optional<double> smallest_max_blind_distance(const PlanarMotion& motion, const PathLimits& limits, const LimitedWay& way,
                                                  const StopTest& stop) {
  const LimitedSearch search(motion, limits, kSpacings[1], way, stop);
  const auto does = [&](double most) {
    PathLimits tried = limits;
    tried.blind->most = most;
    return search.any(tried, kAlike[1]).has_value();
  };
  return least_limit({.least = 0.0, .most = longest_way(motion)}, does, stop);
}

}  // namespace alignability
