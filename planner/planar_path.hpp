// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/progress.hpp"
#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"

namespace alignability {

/// Where a disk faces that is moved in the plane: of importance where risk depends on it.
enum class Facing {
  anywhere,  ///< as is best, place by place: what any headings cost at least
  ahead,     ///< where it goes
};

/// What straight motions of a disk cost and where they are allowed, both exactly. Safe to use from many threads.
struct PlanarMotion {
  std::shared_ptr<const RiskField> risk;
  std::shared_ptr<const ClearanceMap> clearance;
  double weight = 0.0;  ///< of the risk, >= 0
  double radius = 0.0;  ///< of the disk [m]
  Facing facing = Facing::anywhere;

  double cost(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  bool is_allowed(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

 private:
  bool is_faced(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
};

using PlanarPath = std::vector<Eigen::Vector2d>;

/// A path freed of the lattice that it was found on: shortcuts, then vertices moved and added as long as that lowers the cost by the exact
/// integral. Ends where it did, is allowed where the path was, never costs more. Comes to an end
/// early when told to stop.
PlanarPath refined(PlanarPath path, const PlanarMotion& motion, const StopTest& stop = {});

/// Each vertex but the ends moved by steps, from `step` [m] on down to a thousandth of it, as long as that lowers the cost and leaves a
/// path that `is_accepted`, and until told to stop.
void relax(PlanarPath& path, const PlanarMotion& motion, double step, const std::function<bool(const PlanarPath&)>& is_accepted,
           const StopTest& stop = {});

/// The same way with vertices added, so that none is further from the next than `spacing` [m].
PlanarPath subdivided(const PlanarPath& path, double spacing);
/// Likewise, but motions that touch an obstacle and whose pieces would, by rounding, not be allowed stay whole.
PlanarPath subdivided(const PlanarPath& path, double spacing, const PlanarMotion& motion);

/// The path up to where it first comes within a distance of its end [m].
PlanarPath cut_within(PlanarPath path, double distance);

}  // namespace alignability
