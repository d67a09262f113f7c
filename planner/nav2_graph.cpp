// SPDX-License-Identifier: BSD-3-Clause
// The graph file of nav2_route: a GeoJSON FeatureCollection, its points nodes, its lines edges. Coordinates are metres in a frame.
#include <algorithm>
#include <limits>

#include "core/segment.hpp"
#include "planner/graph_builder.hpp"
#include "planner/route_formats.hpp"

namespace alignability::detail {
namespace {

constexpr double kBend = 0.01;  // [m] that a drawn line may leave the straight way by

std::string id_of(const JsonValue& properties, const char* key) {
  return std::to_string(properties.at(key).integer(0, std::numeric_limits<std::uint32_t>::max()));
}

Eigen::Vector2d place(const JsonValue& coordinates) {
  const std::vector<JsonValue> numbers = coordinates.items();
  if (numbers.size() < 2) coordinates.fail("coordinates must be a list of x and y");
  return {numbers[0].number(kPlaces), numbers[1].number(kPlaces)};
}

void add_node(const JsonValue& feature, GraphBuilder& graph) {
  const JsonValue properties = feature.at("properties");
  const std::string id = id_of(properties, "id");
  const auto frame = properties.find("frame");
  if (frame && frame->text() != "map") frame->fail("node '" + id + "' is in the frame '" + frame->text() + "'; only 'map' is read");
  graph.add_node(properties.at("id"), id, place(feature.at("geometry").at("coordinates")));
}

// The points of a line's geometry, which may have none.
std::vector<Eigen::Vector2d> drawn_places(const JsonValue& geometry) {
  const auto coordinates = geometry.find("coordinates");
  if (!coordinates) return {};
  std::vector<JsonValue> lines{*coordinates};
  if (geometry.at("type").text() == "MultiLineString") lines = coordinates->items();
  std::vector<Eigen::Vector2d> places;
  for (const JsonValue& line : lines) {
    for (const JsonValue& point : line.items()) places.push_back(place(point));
  }
  return places;
}

void add_edge(const JsonValue& feature, GraphBuilder& graph) {
  const JsonValue properties = feature.at("properties");
  RouteEdge edge;
  edge.id = id_of(properties, "id");
  edge.from = graph.node(properties.at("startid"), edge.id, "begins", id_of(properties, "startid"));
  edge.to = graph.node(properties.at("endid"), edge.id, "ends", id_of(properties, "endid"));
  const Eigen::Vector2d& from = graph.position(edge.from);
  const Eigen::Vector2d& to = graph.position(edge.to);
  edge.path = straight_way(from, to);
  const auto is_off = [&](const Eigen::Vector2d& at) { return distance_to_segment(at, from, to) > kBend; };
  if (std::ranges::any_of(drawn_places(feature.at("geometry")), is_off)) {
    graph.remark(edge.id, "drawn otherwise, but scored straight from node to node, as nav2 drives");
  }
  graph.add_edge(properties.at("id"), std::move(edge));
}

}  // namespace

Route parse_nav2_graph(const JsonValue& root) {
  GraphBuilder graph;
  std::vector<JsonValue> edges;
  for (const JsonValue& feature : root.at("features").items()) {
    const JsonValue type = feature.at("geometry").at("type");
    const std::string name = type.text();
    if (name == "Point") {
      add_node(feature, graph);
    } else if (name == "LineString" || name == "MultiLineString") {
      edges.push_back(feature);
    } else {
      type.fail("a feature must be a Point (a node), a LineString or a MultiLineString (an edge), not a " + name);
    }
  }
  for (const JsonValue& edge : edges) add_edge(edge, graph);
  return std::move(graph).finish(root);
}

}  // namespace alignability::detail
