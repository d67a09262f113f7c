// SPDX-License-Identifier: BSD-3-Clause
#include "planner/limited_path.hpp"

#include "planner/limited_search.hpp"

namespace alignability {
namespace {

using detail::LimitedSearch;

constexpr double kSpacings[] = {0.5, 0.25};  // of the places searched, the next one where the last leads nowhere [m]
// States that differ by less than such a part of the limit count as one; the next part where that loses the way.
constexpr double kAlike[] = {0.02, 0.001};

template <typename Limit>
bool is_kept(const PlanarPath& path, const PlanarMotion& motion, const Limit& limit) {
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
PlanarPath with_shortcuts(PlanarPath path, const PlanarMotion& motion, const Limit& limit) {
  constexpr std::size_t kWindow = 32;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    for (std::size_t k = std::min(path.size() - 1, i + kWindow); k > i + 1; --k) {
      const PlanarPath replaced(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (motion.cost(path[i], path[k]) > cost_of(replaced, motion) * (1.0 + 1e-9) || !motion.is_allowed(path[i], path[k])) continue;
      PlanarPath shorter = path;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i) + 1, shorter.begin() + static_cast<std::ptrdiff_t>(k));
      if (!is_kept(shorter, motion, limit)) continue;
      path = std::move(shorter);
      break;
    }
  }
  return path;
}

template <typename Limit>
PlanarPath freed(PlanarPath path, const PlanarMotion& motion, const Limit& limit) {
  path = with_shortcuts(std::move(path), motion, limit);
  for (const double spacing : {2.0, 1.0, 0.5}) {
    path = subdivided(path, spacing, motion);
    relax(path, motion, 0.25 * spacing, [&](const PlanarPath& moved) { return is_kept(moved, motion, limit); });
    path = with_shortcuts(std::move(path), motion, limit);
  }
  return path;
}

template <typename Limit>
std::optional<PlanarPath> search(const PlanarMotion& motion, const Limit& limit, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                                 const std::stop_token& stop) {
  for (const double spacing : kSpacings) {
    const LimitedSearch search(motion, limit, spacing, start, goal);
    if (!search.is_feasible(limit, kAlike[1] * limit.most, stop)) continue;
    for (const double share : kAlike) {
      const auto path = search.cheapest(share * limit.most, stop);
      if (path) return freed(*path, motion, limit);
    }
  }
  return std::nullopt;
}

// Of limits like the one given, the smallest that can be kept, to within 1 % or 1 mm; none is smaller than `least`, and one that is greater
// than `most` will do no more.
template <typename Limit>
std::optional<double> smallest(const PlanarMotion& motion, Limit limit, double least, double most, const Eigen::Vector2d& start,
                               const Eigen::Vector2d& goal, const std::stop_token& stop) {
  const LimitedSearch search(motion, limit, kSpacings[1], start, goal);
  const auto does = [&](double limit_tried) {
    limit.most = limit_tried;
    return search.is_feasible(limit, kAlike[1] * limit_tried, stop);
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

// No way over places that are searched is longer than all of them are apart from one another's neighbours.
double longest_way(const PlanarMotion& motion) {
  return 3.0 / kSpacings[1] * motion.clearance->geometry().extent().prod() + 3.0 * motion.clearance->geometry().extent().sum();
}

}  // namespace

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const ErrorLimit& limit) { return is_kept(path, motion, limit); }

bool keeps(const PlanarPath& path, const PlanarMotion& motion, const BlindLimit& limit) { return is_kept(path, motion, limit); }

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const ErrorLimit& limit, const Eigen::Vector2d& start,
                                      const Eigen::Vector2d& goal, const std::stop_token& stop) {
  return limit.model.least > limit.most ? std::nullopt : search(motion, limit, start, goal, stop);
}

std::optional<PlanarPath> path_within(const PlanarMotion& motion, const BlindLimit& limit, const Eigen::Vector2d& start,
                                      const Eigen::Vector2d& goal, const std::stop_token& stop) {
  return search(motion, limit, start, goal, stop);
}

std::optional<double> smallest_limit(const PlanarMotion& motion, const ErrorModel& model, const Eigen::Vector2d& start,
                                     const Eigen::Vector2d& goal, const std::stop_token& stop) {
  const double most = model.least + model.growth * longest_way(motion);
  return smallest(motion, ErrorLimit{model, most}, model.least, most, start, goal, stop);
}

std::optional<double> smallest_blind_limit(const PlanarMotion& motion, double recovery, const Eigen::Vector2d& start,
                                           const Eigen::Vector2d& goal, const std::stop_token& stop) {
  const double most = longest_way(motion);
  return smallest(motion, BlindLimit{most, recovery}, 0.0, most, start, goal, stop);
}

}  // namespace alignability
