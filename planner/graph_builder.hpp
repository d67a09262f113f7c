// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "planner/json_file.hpp"
#include "planner/route.hpp"

namespace alignability::detail {

/// Puts a graph together from a file's nodes and edges: all nodes first. Faults are InputErrors where they stand in the file.
class GraphBuilder {
 public:
  /// `at` is what names the node in an error.
  void add_node(const JsonValue& at, const std::string& id, const Eigen::Vector2d& position);
  /// The node of an edge: `end` says "begins" or "ends".
  std::size_t node(const JsonValue& at, const std::string& edge_id, const std::string& end, const std::string& node_id) const;
  const Eigen::Vector2d& position(std::size_t node) const { return graph_.nodes[node].position; }
  /// Leaves out an edge that leads nowhere, and remarks on it.
  void add_edge(const JsonValue& at, RouteEdge edge);
  /// What is to be said of an edge; said of several, it is one sentence that names some of them.
  void remark(const std::string& edge_id, const std::string& said);

  /// What has been added; `root` stands for the file.
  Route finish(const JsonValue& root) &&;

 private:
  RouteGraph graph_;
  std::map<std::string, std::size_t> nodes_;
  std::set<std::string> edges_;
  std::map<std::string, std::vector<std::string>> remarks_;
};

/// A straight way from one place to another, looking along it.
std::vector<Pose2> straight_way(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace alignability::detail
