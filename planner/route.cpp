// SPDX-License-Identifier: BSD-3-Clause
#include "planner/route.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/input_error.hpp"

namespace alignability {
namespace {

std::size_t index_of(const RouteGraph& graph, const std::string& id) {
  const auto found = std::ranges::find(graph.nodes, id, &RouteNode::id);
  if (found != graph.nodes.end()) return static_cast<std::size_t>(found - graph.nodes.begin());
  std::vector<std::string> ids;
  for (const RouteNode& node : graph.nodes) ids.push_back(node.id);
  throw std::invalid_argument("there is no node '" + id + '\'' + did_you_mean(id, ids));
}

const RouteEdge* edge_between(const RouteGraph& graph, std::size_t from, std::size_t to) {
  const RouteEdge* only = nullptr;
  for (const RouteEdge& edge : graph.edges) {
    if (edge.from != from || edge.to != to) continue;
    if (only != nullptr && only->path != edge.path) {
      throw std::invalid_argument("the edges '" + only->id + "' and '" + edge.id + "' lead from node '" + graph.nodes[from].id +
                                  "' to node '" + graph.nodes[to].id + "' on different ways");
    }
    if (only == nullptr) only = &edge;
  }
  return only;
}

const RouteEdge& edge_of(const RouteGraph& graph, const std::string& from_id, const std::string& to_id) {
  const std::size_t from = index_of(graph, from_id);
  const std::size_t to = index_of(graph, to_id);
  if (const RouteEdge* edge = edge_between(graph, from, to)) return *edge;
  const bool leads_back = edge_between(graph, to, from) != nullptr;
  throw std::invalid_argument("no edge leads from node '" + from_id + "' to node '" + to_id + '\'' +
                              (leads_back ? ", though one leads back" : ""));
}

}  // namespace

std::vector<Pose2> path_along(const RouteGraph& graph, std::span<const std::string> node_ids) {
  if (node_ids.size() < 2) throw std::invalid_argument("a path along nodes needs at least two of them");
  std::vector<Pose2> path;
  for (std::size_t i = 0; i + 1 < node_ids.size(); ++i) {
    const std::vector<Pose2>& next = edge_of(graph, node_ids[i], node_ids[i + 1]).path;
    const bool goes_on = !path.empty() && path.back() == next.front();
    path.insert(path.end(), next.begin() + (goes_on ? 1 : 0), next.end());
  }
  return path;
}

}  // namespace alignability
