// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/progress.hpp"
#include "planner/limited_path.hpp"

namespace alignability::detail {

/// A search for ways on which limits are kept that depend on the way so far, as what comes of a place depends on the state in which the
/// robot gets there.
class LimitedSearch {
 public:
  /// Over places every `spacing` metres. Start and goal must be allowed. Within the tolerance of the goal the limits need not be kept: the
  /// way ends there. O(area / spacing²), some 900 bytes a place. Stopped, it finds no way.
  LimitedSearch(const PlanarMotion& motion, const PathLimits& limits, double spacing, const LimitedWay& way, const StopTest& stop);

  /// Some way that keeps limits, which may be others of the same kinds; nullopt where there is none. Throws Interrupted.
  std::optional<PlanarPath> any(const PathLimits& limits, double alike) const;

  /// The cheapest way that keeps the limits, but for what `alike` costs; nullopt where there is none. Throws Interrupted. By A* over
  /// labels, a place and a state each, those dropped that another at the place makes superfluous (Handler and Zang 1980).
  std::optional<PlanarPath> cheapest(double alike) const;

 private:
  static constexpr int kNear = 2;  // [places] along either axis that start and goal are joined to
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  using State = PathLimits::State;

  struct Edge {
    std::size_t to;
    double cost;
    PathLimits::Change change;
  };

  // A way to a place.
  struct Label {
    std::size_t node;
    std::size_t before;  // the label it came from
    double cost;
    State state;
  };

  // Follows labels in the order of their rank, those of infinite rank not at all.
  template <typename Rank>
  std::optional<PlanarPath> search(const PathLimits& limits, double alike, Rank rank) const;

  std::size_t at_start() const { return grid_.size(); }
  std::size_t at_goal() const { return grid_.size() + 1; }
  Eigen::Vector2d place(std::size_t node) const;
  void connect(std::size_t node);
  void connect_near(std::size_t node, int reach);
  void join(std::size_t a, std::size_t b);
  Eigen::Vector2d end(std::size_t from, std::size_t to) const;
  std::optional<State> after(const PathLimits& limits, const Label& label, const Edge& edge) const;
  std::vector<double> costs_to_goal() const;
  PlanarPath path_of(const std::vector<Label>& labels, std::size_t last) const;

  const PlanarMotion& motion_;
  PathLimits limits_;
  GridGeometry grid_;
  LimitedWay way_;
  StopTest stop_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace alignability::detail
