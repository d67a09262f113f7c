// SPDX-License-Identifier: BSD-3-Clause
#include "planner/graph_builder.hpp"

#include <algorithm>

#include "planner/headings.hpp"

namespace alignability::detail {
namespace {

// "edge '7'", "edges '7', '8', '9' and 3 others".
std::string named(const std::vector<std::string>& ids) {
  constexpr std::size_t kMostNamed = 3;
  std::string names = ids.size() == 1 ? "edge" : "edges";
  for (std::size_t i = 0; i < std::min(ids.size(), kMostNamed); ++i) names += (i == 0 ? " '" : ", '") + ids[i] + '\'';
  const std::size_t others = ids.size() - std::min(ids.size(), kMostNamed);
  return names + (others == 0 ? "" : others == 1 ? " and another" : " and " + std::to_string(others) + " others");
}

bool stays(const std::vector<Pose2>& path) {
  return std::ranges::all_of(path, [&](const Pose2& pose) { return pose.position() == path.front().position(); });
}

}  // namespace

void GraphBuilder::add_node(const JsonValue& at, const std::string& id, const Eigen::Vector2d& position) {
  if (!nodes_.emplace(id, graph_.nodes.size()).second) at.fail("there is another node '" + id + '\'');
  graph_.nodes.push_back({id, position});
}

std::size_t GraphBuilder::node(const JsonValue& at, const std::string& edge_id, const std::string& end, const std::string& node_id) const {
  const auto found = nodes_.find(node_id);
  if (found == nodes_.end()) at.fail("edge '" + edge_id + "' " + end + " at node '" + node_id + "', which there is none of");
  return found->second;
}

void GraphBuilder::add_edge(const JsonValue& at, RouteEdge edge) {
  if (!edges_.insert(edge.id).second) at.fail("there is another edge '" + edge.id + '\'');
  if (stays(edge.path)) {
    remark(edge.id, "left out, as it leads nowhere");
  } else {
    graph_.edges.push_back(std::move(edge));
  }
}

void GraphBuilder::remark(const std::string& edge_id, const std::string& said) {
  std::vector<std::string>& ids = remarks_[said];
  if (ids.empty() || ids.back() != edge_id) ids.push_back(edge_id);
}

Route GraphBuilder::finish(const JsonValue& root) && {
  if (graph_.edges.empty()) root.fail("has no edges to score");
  Route route{.path = {}, .graph = std::move(graph_), .remarks = {}};
  for (const auto& [said, ids] : remarks_) route.remarks.push_back(named(ids) + ": " + said);
  return route;
}

std::vector<Pose2> straight_way(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return looking_ahead({{from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0}}, 0.0);
}

}  // namespace alignability::detail
