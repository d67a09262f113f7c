// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace alignability {

/// The cheapest of the paths that leave out vertices, none further apart than a window of 32. The motion's `cost(from, to)` and
/// `is_allowed(from, to)` say of two vertices what the way between them is.
template <typename Vertex, typename Motion>
std::vector<Vertex> with_shortcuts(const std::vector<Vertex>& path, const Motion& motion) {
  constexpr std::size_t kWindow = 32;
  constexpr double kRounding = 1e-9;  // of the cost
  std::vector<double> cost(path.size(), std::numeric_limits<double>::infinity());
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
  std::vector<Vertex> shorter;
  for (std::size_t at = path.size() - 1; at > 0; at = before[at]) shorter.push_back(path[at]);
  shorter.push_back(path.front());
  return {shorter.rbegin(), shorter.rend()};
}

}  // namespace alignability
