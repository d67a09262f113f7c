// SPDX-License-Identifier: BSD-3-Clause
// VDMA's Layout Interchange Format, versions 1.0 (2024) and 2.0: what VDA 5050 fleets exchange. The two differ in names.
#include <algorithm>
#include <array>

#include "planner/graph_builder.hpp"
#include "planner/nurbs.hpp"
#include "planner/route_formats.hpp"

namespace alignability::detail {
namespace {

constexpr double kTolerance = 1e-3;  // [m] of a curve drawn as straight lines
constexpr double kGap = 0.01;        // [m] that a trajectory may miss its nodes by

struct Layout {
  JsonValue json;
  std::size_t origin = 0;
};

std::vector<Layout> layouts_of(const JsonValue& root) {
  std::vector<Layout> layouts;
  if (const auto own = root.find("layouts")) {
    for (const JsonValue& layout : own->items()) layouts.push_back({layout});
    return layouts;
  }
  const std::vector<JsonValue> origins = root.at("origins").items();
  for (std::size_t i = 0; i < origins.size(); ++i) {
    for (const JsonValue& layout : origins[i].at("layouts").items()) layouts.push_back({layout, i});
  }
  return layouts;
}

Eigen::Vector2d place(const JsonValue& json) { return {json.at("x").number(kPlaces), json.at("y").number(kPlaces)}; }

// Adds the nodes of one map, and holds the ids of the others.
class NodeReader {
 public:
  NodeReader(const RouteFileOptions& options, GraphBuilder& graph) : wanted_(options.map), graph_(graph) {}

  void add(const JsonValue& node, std::size_t origin) {
    const std::string id = node.at("nodeId").text();
    const auto map = node.find("mapId");
    const std::string name = map ? map->text() : "";
    maps_.insert(name);
    if (wanted_ && *wanted_ != name) {
      elsewhere_.insert(id);
      return;
    }
    if (!first_) first_ = First{id, name, origin};
    const std::string others = "node '" + first_->id + '\'';
    if (name != first_->map)
      map.value_or(node).fail("node '" + id + "' lies on the map '" + name + "', " + others + " on '" + first_->map + "': choose a map");
    if (origin != first_->origin) node.fail("node '" + id + "' has another origin than " + others + ": what lies where is not known");
    graph_.add_node(node.at("nodeId"), id, place(node.at("nodePosition")));
  }

  void finish(const JsonValue& root) const {
    if (first_) return;
    std::string names;
    for (const std::string& map : maps_) names += (names.empty() ? "'" : ", '") + map + '\'';
    root.fail(maps_.empty() ? "has no nodes" : "no node lies on the map '" + *wanted_ + "', but on " + names);
  }

  bool is_elsewhere(const std::string& id) const { return elsewhere_.contains(id); }

 private:
  struct First {
    std::string id;
    std::string map;
    std::size_t origin = 0;
  };

  std::optional<std::string> wanted_;
  GraphBuilder& graph_;
  std::optional<First> first_;
  std::set<std::string> maps_;
  std::set<std::string> elsewhere_;
};

std::vector<std::string> vehicles_of(const JsonValue& property) {
  const auto types = property.find("mobileRobotTypes");
  if (!types) return {property.at("vehicleTypeId").text()};
  std::vector<std::string> names;
  for (const JsonValue& type : types->items()) names.push_back(type.at("manufacturer").text() + '.' + type.at("seriesName").text());
  return names;
}

Nurbs nurbs_of(const JsonValue& trajectory, const std::string& edge_id) {
  Nurbs curve;
  if (const auto degree = trajectory.find("degree")) curve.degree = static_cast<int>(degree->integer(1, std::numeric_limits<int>::max()));
  for (const JsonValue& knot : trajectory.at("knotVector").items()) curve.knots.push_back(knot.number(kFinite));
  for (const JsonValue& point : trajectory.at("controlPoints").items()) {
    const auto weight = point.find("weight");
    curve.points.push_back({place(point), weight ? weight->number(kPositive) : 1.0});
  }
  if (const auto fault = fault_of_nurbs(curve)) trajectory.fail("the trajectory of edge '" + edge_id + "': " + *fault);
  return curve;
}

// Which way the robot looks on an edge: along it, turned by an angle, or one way throughout.
struct Orientation {
  double angle = 0.0;  // [rad]
  bool is_global = false;
};

Orientation orientation_of(const JsonValue& property, const std::string& edge_id, GraphBuilder& graph) {
  Orientation orientation;
  if (const auto type = property.find("orientationType")) {
    const std::string name = type->text();
    if (name != "GLOBAL" && name != "TANGENTIAL") type->fail("'orientationType' must be GLOBAL or TANGENTIAL, not '" + name + '\'');
    orientation.is_global = name == "GLOBAL";
  }
  if (const auto angle = property.find("vehicleOrientation")) orientation.angle = angle->number(kFinite);
  if (const auto angles = property.find("mobileRobotOrientations")) {
    const std::vector<JsonValue> all = angles->items();
    if (!all.empty()) orientation.angle = all.front().number(kFinite);
    if (all.size() > 1) graph.remark(edge_id, "may be driven in several orientations, but scored in the first");
  }
  return orientation;
}

std::vector<Pose2> path_of(const JsonValue& property, const RouteEdge& edge, GraphBuilder& graph) {
  const Eigen::Vector2d& from = graph.position(edge.from);
  const Eigen::Vector2d& to = graph.position(edge.to);
  std::vector<Pose2> path;
  if (const auto trajectory = property.find("trajectory")) {
    path = flattened(nurbs_of(*trajectory, edge.id), kTolerance);
    if (path.empty()) trajectory->fail("the trajectory of edge '" + edge.id + "' stays in one place");
    if ((path.front().position() - from).norm() > kGap || (path.back().position() - to).norm() > kGap) {
      graph.remark(edge.id, "scored along a trajectory that does not begin and end at its nodes");
    }
  } else {
    path = straight_way(from, to);
    if (property.find("physicalLineGuidedProperty")) graph.remark(edge.id, "guided by a line on the floor, but scored straight");
  }
  const Orientation orientation = orientation_of(property, edge.id, graph);
  for (Pose2& pose : path) pose.yaw = normalized_angle(orientation.angle + (orientation.is_global ? 0.0 : pose.yaw));
  return path;
}

class EdgeReader {
 public:
  EdgeReader(const RouteFileOptions& options, const NodeReader& nodes, GraphBuilder& graph)
      : wanted_(options.vehicle), nodes_(nodes), graph_(graph) {}

  void add(const JsonValue& json) {
    RouteEdge edge;
    edge.id = json.at("edgeId").text();
    const std::string from = json.at("startNodeId").text();
    const std::string to = json.at("endNodeId").text();
    if (nodes_.is_elsewhere(from) && nodes_.is_elsewhere(to)) return;
    if (nodes_.is_elsewhere(from) || nodes_.is_elsewhere(to)) {
      graph_.remark(edge.id, "left out, as one of its nodes lies on another map");
      return;
    }
    edge.from = graph_.node(json.at("startNodeId"), edge.id, "begins", from);
    edge.to = graph_.node(json.at("endNodeId"), edge.id, "ends", to);
    const auto newer = json.find("mobileRobotTypeEdgeProperties");
    const JsonValue properties = newer ? *newer : json.at("vehicleTypeEdgeProperties");
    for (const JsonValue& property : properties.items()) read(property, edge);
    if (!edge.path.empty()) {
      graph_.add_edge(json.at("edgeId"), std::move(edge));
    } else if (properties.items().empty()) {
      properties.fail("edge '" + edge.id + "' is for no vehicle");
    }
  }

  void finish(const JsonValue& root) const {
    if (!wanted_ || vehicles_.contains(*wanted_)) return;
    std::string names;
    for (const std::string& vehicle : vehicles_) names += (names.empty() ? "'" : ", '") + vehicle + '\'';
    root.fail("no edge is for the vehicle '" + *wanted_ + "', but for " + names);
  }

 private:
  void read(const JsonValue& property, RouteEdge& edge) {
    const std::vector<std::string> vehicles = vehicles_of(property);
    vehicles_.insert(vehicles.begin(), vehicles.end());
    if (wanted_ && std::ranges::find(vehicles, *wanted_) == vehicles.end()) return;
    std::vector<Pose2> path = path_of(property, edge, graph_);
    if (!edge.path.empty() && edge.path != path) property.fail("vehicles drive edge '" + edge.id + "' in different ways: choose a vehicle");
    edge.path = std::move(path);
  }

  std::optional<std::string> wanted_;
  const NodeReader& nodes_;
  GraphBuilder& graph_;
  std::set<std::string> vehicles_;
};

}  // namespace

Route parse_lif(const JsonValue& root, const RouteFileOptions& options) {
  GraphBuilder graph;
  NodeReader nodes(options, graph);
  const std::vector<Layout> layouts = layouts_of(root);
  for (const Layout& layout : layouts) {
    for (const JsonValue& node : layout.json.at("nodes").items()) nodes.add(node, layout.origin);
  }
  nodes.finish(root);
  EdgeReader edges(options, nodes, graph);
  for (const Layout& layout : layouts) {
    for (const JsonValue& edge : layout.json.at("edges").items()) edges.add(edge);
  }
  edges.finish(root);
  return std::move(graph).finish(root);
}

}  // namespace alignability::detail
