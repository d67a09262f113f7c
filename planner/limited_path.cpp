// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_path.hpp"

#include "planner/limited_search.hpp"

namespace alignability {
namespace {

using detail::LimitedSearch;

constexpr double kSpacings[] = {0.5, 0.25};  // of the places searched, the next one where the last leads nowhere [m]
// States that differ by less than such a share of the limit count as one; the next share where that loses the way.
constexpr double kAlike[] = {0.02, 0.001};

// Up to where the path is within the tolerance of its end.
template <typename Limit>
bool is_kept(const PlanarPath& whole, const PlanarMotion& motion, const Limit& limit, double tolerance) {
  const PlanarPath path = cut_within(whole, tolerance);
  std::optional<typename Limit::State> state = limit.at_start();
  for (std::size_t i = 1; state && i < path.size(); ++i) state = limit.after(*state, path[i - 1], path[i], *motion.risk);
  return state.has_value();
}

double cost_of(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += motion.cost(path[i - 1], path[i]);
  return cost;
}

// Leaves out vertices, the longest row of them first, as long as that makes the path no dearer and keeps the limit.
template <typename Limit>
PlanarPath with_shortcuts(PlanarPath path, const PlanarMotion& motion, const Limit& limit, double tolerance) {
  constexpr std::size_t kWindow = 32;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    for (std::size_t k = std::min(path.size() - 1, i + kWindow); k > i + 1; --k) {
      const PlanarPath replaced(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (motion.cost(path[i], path[k]) > cost_of(replaced, motion) * (1.0 + 1e-9) || !motion.is_allowed(path[i], path[k])) continue;
      PlanarPath shorter = path;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i) + 1, shorter.begin() + static_cast<std::ptrdiff_t>(k));
      if (!is_kept(shorter, motion, limit, tolerance)) continue;
      path = std::move(shorter);
      break;
    }
  }
  return path;
}

template <typename Limit>
PlanarPath freed(PlanarPath path, const PlanarMotion& motion, const Limit& limit, double tolerance) {
  path = with_shortcuts(std::move(path), motion, limit, tolerance);
  for (const double spacing : {2.0, 1.0, 0.5}) {
    path = subdivided(path, spacing, motion);
    relax(path, motion, 0.25 * spacing, [&](const PlanarPath& moved) { return is_kept(moved, motion, limit, tolerance); });
    path = with_shortcuts(std::move(path), motion, limit, tolerance);
  }
  return path;
}

template <typename Limit>
std::optional<PlanarPath> search(const PlanarMotion& motion, const Limit& limit, const LimitedWay& way, const std::stop_token& stop) {
  for (const double spacing : kSpacings) {
    const LimitedSearch search(motion, limit, spacing, way);
    const auto any = search.any(limit, kAlike[1], stop);
    if (!any) continue;
    for (const double alike : kAlike) {
      if (const auto path = search.cheapest(alike, stop)) return freed(*path, motion, limit, way.tolerance);
    }
    return freed(*any, motion, limit, way.tolerance);
  }
  return std::nullopt;
}

// Of limits like the one given, the smallest that can be kept, to within 1 % or 1 mm; none is smaller than `least`, and one that is greater
// than the one given will do no more.
template <typename Limit>
std::optional<double> smallest(const PlanarMotion& motion, Limit limit, double least, const LimitedWay& way, const std::stop_token& stop) {
  const double most = limit.most;
  const LimitedSearch search(motion, limit, kSpacings[1], way);
  const auto does = [&](double tried) {
    limit.most = tried;
    return search.any(limit, kAlike[1], stop).has_value();
  };
  double too_little = least;
  double enough = std::max(2.0 * least, 1e-3);
  for (; !does(enough); enough *= 2.0) {
    if (enough > most || stop.stop_requested()) return std::nullopt;
    too_little = enough;
  }
  while (enough - too_little > std::max(0.01 * enough, 1e-3)) {
    const double middle = 0.5 * (enough + too_little);
    (does(middle) ? enough : too_little) = middle;
  }
  return stop.stop_requested() ? std::nullopt : std::optional(enough);
}

// More metres than any way can have that is at each place once.
double longest_way(const PlanarMotion& motion) {
  const Eigen::Vector2d extent = motion.clearance->geometry().extent();
  return 3.0 / kSpacings[1] * extent.prod() + 3.0 * extent.sum();
}

}  // namespace

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const ErrorLimit& limit) { return is_kept(path, motion, limit, 0.0); }

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const BlindLimit& limit) { return is_kept(path, motion, limit, 0.0); }

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const ErrorLimit& limit, const LimitedWay& way,
                                      const std::stop_token& stop) {
  return limit.model.least > limit.most ? std::nullopt : search(motion, limit, way, stop);
}

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const BlindLimit& limit, const LimitedWay& way,
                                      const std::stop_token& stop) {
  return search(motion, limit, way, stop);
}

std::optional<double> smallest_limit(const PlanarMotion& motion, const ErrorModel& model, const LimitedWay& way,
                                     const std::stop_token& stop) {
  return smallest(motion, ErrorLimit{model, model.least + model.growth * longest_way(motion)}, model.least, way, stop);
}

std::optional<double> smallest_blind_limit(const PlanarMotion& motion, double recovery, const LimitedWay& way,
                                           const std::stop_token& stop) {
  return smallest(motion, BlindLimit{longest_way(motion), recovery}, 0.0, way, stop);
}

}  // namespace alignability
