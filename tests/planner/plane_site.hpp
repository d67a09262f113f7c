// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "planner/planar_path.hpp"

namespace alignability::test {

/// A site whose α is given by place, at α-cells as small as the map's.
struct PlaneSite {
  PlaneSite(const GridGeometry& geometry, const std::function<float(Eigen::Vector2d)>& alpha_at,
            const std::function<bool(Eigen::Vector2d)>& is_wall, double weight, double radius) {
    Grid<float> occupied(geometry, 0.0f);
    Grid<float> alpha(geometry, 0.0f);
    for (std::size_t i = 0; i < geometry.size(); ++i) {
      const Eigen::Vector2d at = geometry.center(geometry.cell_of(i));
      occupied[i] = is_wall(at) ? 1.0f : 0.0f;
      alpha[i] = alpha_at(at);
    }
    const OccupancyMap occupancy(std::move(occupied));
    AlignabilityMap map;
    map.geometry = geometry;
    map.layers.push_back({"alpha", std::move(alpha)});
    motion = {std::make_shared<const RiskField>(map, occupancy, RiskOptions{}), std::make_shared<const ClearanceMap>(occupancy), weight,
              radius};
  }

  PlanarMotion motion;
};

inline double cost_of(const PlanarPath& path, const PlanarMotion& motion) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += motion.cost(path[i - 1], path[i]);
  return cost;
}

inline bool nowhere(const Eigen::Vector2d&) { return false; }
inline float safe(const Eigen::Vector2d&) { return 1.0f; }

inline GridGeometry square(double resolution, int cells) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = cells;
  geometry.height = cells;
  return geometry;
}

/// The least cost over the corners of cells of a grid `finer` times as fine as the map, by motions to at least 32 neighbours; infinite
/// without a way.
double least_cost_by_graph(const PlanarMotion& motion, int finer, const Eigen::Vector2d& start, const Eigen::Vector2d& goal);

}  // namespace alignability::test
