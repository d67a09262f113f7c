// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace alignability {

struct RouteNode {
  std::string id;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< in `map` [m]
};

/// A way from one node to another, in that direction alone.
struct RouteEdge {
  std::string id;
  std::size_t from = 0;  ///< of the graph's nodes
  std::size_t to = 0;
  std::vector<Pose2> path;  ///< straight between, the robot turning evenly; not empty
};

struct RouteGraph {
  std::vector<RouteNode> nodes;  ///< no two of one id
  std::vector<RouteEdge> edges;  ///< likewise
};

/// Ways that are there already: one path, or the lanes of a graph.
struct Route {
  std::vector<Pose2> path;  ///< empty where there is a graph; straight between, the robot turning evenly
  RouteGraph graph;
  std::vector<std::string> remarks;  ///< what the file says that the route does not follow, and what it leaves open, a sentence each
};

/// The edges from each of the nodes to the next as one path, on which the robot turns on the spot where one edge does not go on as the
/// last ended. Throws std::invalid_argument for fewer than two ids, an id that no node has, nodes that no edge joins, and where several
/// edges join two nodes on different ways.
std::vector<Pose2> path_along(const RouteGraph& graph, std::span<const std::string> node_ids);

}  // namespace alignability
