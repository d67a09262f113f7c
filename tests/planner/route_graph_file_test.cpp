// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "planner/route_file.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

using Path = std::vector<Pose2>;

constexpr double kUp = std::numbers::pi / 2.0;

// As nav2's tools and QGIS write it.
constexpr const char* kNav2 = R"({
  "type": "FeatureCollection", "name": "graph",
  "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}},
  "features": [
    {"type": "Feature", "properties": {"id": 0, "frame": "map"}, "geometry": {"type": "Point", "coordinates": [1.0, 2.0]}},
    {"type": "Feature", "properties": {"id": 7, "startid": 0, "endid": 2, "cost": 3.0, "metadata": {"speed_limit": 0.5}},
     "geometry": {"type": "MultiLineString", "coordinates": [[[1.0, 2.0], [4.0, 2.0]]]}},
    {"type": "Feature", "properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [4.0, 6.0, 0.0]}},
    {"type": "Feature", "properties": {"id": 2.0}, "geometry": {"type": "Point", "coordinates": [4.0, 2.0]}},
    {"type": "Feature", "properties": {"id": 8, "startid": 2, "endid": 1}, "geometry": {"type": "MultiLineString"}},
    {"type": "Feature", "properties": {"id": 9, "startid": 1, "endid": 2}, "geometry": {"type": "LineString", "coordinates": [[4.0, 6.0], [4.0, 2.0]]}}
  ]
})";

constexpr const char* kLif = R"({
  "metaInformation": {"projectIdentification": "hall", "creator": "me", "exportTimestamp": "2024-04-15T11:40:03.12Z", "lifVersion": "1.0.0"},
  "layouts": [{
    "layoutId": "ground", "layoutVersion": "1", "stations": [],
    "nodes": [
      {"nodeId": "A", "mapId": "hall", "nodePosition": {"x": 1.0, "y": 2.0}, "vehicleTypeNodeProperties": [{"vehicleTypeId": "truck"}]},
      {"nodeId": "B", "mapId": "hall", "nodePosition": {"x": 4.0, "y": 2.0}, "vehicleTypeNodeProperties": [{"vehicleTypeId": "truck"}]},
      {"nodeId": "C", "mapId": "hall", "nodePosition": {"x": 4.0, "y": 6.0}, "vehicleTypeNodeProperties": [{"vehicleTypeId": "truck"}]}
    ],
    "edges": [
      {"edgeId": "A-B", "startNodeId": "A", "endNodeId": "B",
       "vehicleTypeEdgeProperties": [{"vehicleTypeId": "truck", "rotationAllowed": false, "trajectory": null}]},
      {"edgeId": "B-C", "startNodeId": "B", "endNodeId": "C",
       "vehicleTypeEdgeProperties": [{"vehicleTypeId": "truck", "rotationAllowed": false,
         "trajectory": {"degree": 1, "knotVector": [0, 0, 0.5, 1, 1],
           "controlPoints": [{"x": 4.0, "y": 2.0}, {"x": 8.0, "y": 2.0, "weight": 2.0}, {"x": 4.0, "y": 6.0}]}}]}
    ]
  }]
})";

constexpr const char* kNewerLif = R"({
  "metaInformation": {"lifId": "hall", "creator": "me", "exportTimestamp": "2026-04-15T11:40:03.12Z", "lifVersion": "2.0.0"},
  "origins": [{"originId": "gate", "layouts": [{
    "layoutId": "ground", "layoutVersion": "1",
    "nodes": [
      {"nodeId": "A", "mapId": "hall", "nodePosition": {"x": 1.0, "y": 2.0}},
      {"nodeId": "B", "mapId": "hall", "nodePosition": {"x": 4.0, "y": 2.0}}
    ],
    "edges": [
      {"edgeId": "A-B", "startNodeId": "A", "endNodeId": "B", "mobileRobotTypeEdgeProperties": [
        {"mobileRobotTypes": [{"manufacturer": "Acme", "seriesName": "One"}, {"manufacturer": "Acme", "seriesName": "Two"}]}]}
    ]
  }]}]
})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) ADD_FAILURE() << "not in the file: " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// A file with one thing in it changed, and the place of '^' in what was put in: the place of the fault.
struct Broken {
  std::string text;
  std::string place;
};

Broken broken(const std::string& good, const std::string& from, const std::string& to) {
  std::string text = replaced(good, from, to);
  const std::size_t fault = text.find('^');
  if (fault == std::string::npos) return {text, ""};
  text.erase(fault, 1);
  const std::string before = text.substr(0, fault);
  return {text, ':' + std::to_string(std::ranges::count(before, '\n') + 1) + ':' + std::to_string(fault - (before.rfind('\n') + 1) + 1)};
}

struct Fault {
  const char* from;
  const char* to;
  const char* message;
};

class GraphFile : public testing::Test {
 protected:
  Route read(const std::string& text, const RouteFileOptions& options = {}) const {
    return read_route(folder.write("graph.json", text), options);
  }
  std::string error(const std::string& text, const RouteFileOptions& options = {}) const {
    const std::string message = test::thrown_message([&] { read(text, options); });
    const std::string file = (folder / "graph.json").string();
    return message.starts_with(file) ? message.substr(file.size()) : message;
  }

  void expect_faults(const std::string& good, std::span<const Fault> faults) const {
    for (const Fault& fault : faults) {
      const Broken file = broken(good, fault.from, fault.to);
      EXPECT_EQ(error(file.text), file.place + ": " + fault.message) << fault.to;
    }
  }

  test::TemporaryFolder folder;
};

TEST_F(GraphFile, OfNav2HasNodesAndStraightEdges) {
  const Route route = read(kNav2);
  EXPECT_TRUE(route.path.empty());
  EXPECT_TRUE(route.remarks.empty());
  ASSERT_EQ(route.graph.nodes.size(), 3u);
  EXPECT_EQ(route.graph.nodes[1].id, "1");
  EXPECT_EQ(route.graph.nodes[1].position, Eigen::Vector2d(4.0, 6.0));
  ASSERT_EQ(route.graph.edges.size(), 3u);
  const RouteEdge& first = route.graph.edges[0];
  EXPECT_EQ(first.id, "7");
  EXPECT_EQ(first.from, 0u);
  EXPECT_EQ(first.to, 2u);
  EXPECT_EQ(first.path, (Path{{1, 2, 0}, {4, 2, 0}}));
  EXPECT_EQ(route.graph.edges[1].path, (Path{{4, 2, kUp}, {4, 6, kUp}}));
}

TEST_F(GraphFile, OfNav2IsReadAsGeojsonToo) { EXPECT_EQ(read_route(folder.write("graph.geojson", kNav2), {}).graph.edges.size(), 3u); }

TEST_F(GraphFile, OfNav2RemarksOnEdgesThatAreDrawnBent) {
  const std::string bent = replaced(replaced(kNav2, "[[[1.0, 2.0], [4.0, 2.0]]]", "[[[1.0, 2.0], [2.0, 3.0]], [[2.0, 3.0], [4.0, 2.0]]]"),
                                    "[[4.0, 6.0], [4.0, 2.0]]", "[[4.0, 6.0], [4.0, 1.0]]");
  const Route route = read(bent);
  EXPECT_EQ(route.graph.edges[0].path, (Path{{1, 2, 0}, {4, 2, 0}}));
  EXPECT_EQ(route.remarks,
            std::vector<std::string>{"edges '7', '9': drawn otherwise, but scored straight from node to node, as nav2 drives"});
}

TEST_F(GraphFile, LeavesOutEdgesThatLeadNowhere) {
  const Route route = read(replaced(kNav2, R"("startid": 2, "endid": 1)", R"("startid": 2, "endid": 2)"));
  EXPECT_EQ(route.graph.edges.size(), 2u);
  EXPECT_EQ(route.remarks, std::vector<std::string>{"edge '8': left out, as it leads nowhere"});
}

TEST_F(GraphFile, NamesOfManyEdgesAFew) {
  std::string text = R"({"type": "FeatureCollection", "features": [
    {"properties": {"id": 0}, "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [1, 0]}})";
  for (int id = 10; id < 15; ++id) {
    text += R"(, {"properties": {"startid": 0, "endid": 1, "id": )";
    text += std::to_string(id);
    text += R"(}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [0, 1]]}})";
  }
  text += "]}";
  EXPECT_THAT(read(text).remarks, testing::ElementsAre(testing::StartsWith("edges '10', '11', '12' and 2 others: drawn otherwise")));
}

TEST_F(GraphFile, OfNav2IsRefusedWhereItIsWrong) {
  const Fault faults[] = {
      {R"("endid": 2, "cost")", R"("endid": ^12, "cost")", "edge '7' ends at node '12', which there is none of"},
      {R"("startid": 2)", R"("startid": ^12)", "edge '8' begins at node '12', which there is none of"},
      {R"({"id": 1})", R"({"id": ^0})", "there is another node '0'"},
      {R"({"id": 8,)", R"({"id": ^7,)", "there is another edge '7'"},
      {R"({"id": 1})", R"(^{"name": 1})", "missing key 'id'"},
      {R"({"id": 1})", R"({"id": ^"1"})", R"('id' must be a whole number from 0 to 4294967295, not "1")"},
      {R"({"id": 1})", R"({"id":   ^1.5})", "'id' must be a whole number from 0 to 4294967295, not 1.5"},
      {R"({"id": 1})", R"({"id": ^-1})", "'id' must be a whole number from 0 to 4294967295, not -1"},
      {R"({"id": 1})", R"({"id": 1, ^"id": 2})", "key 'id' is given twice"},
      {R"("frame": "map")", R"("frame": ^"odom")", "node '0' is in the frame 'odom'; only 'map' is read"},
      {R"({"id": 9, "startid": 1, )", R"(^{"id": 9, )", "missing key 'startid'"},
      {"[4.0, 6.0, 0.0]", "^[4.0]", "coordinates must be a list of x and y"},
      {"[4.0, 6.0, 0.0]", "[4.0, ^null]", "an item of 'coordinates' must be a number, not null"},
      {"[4.0, 6.0, 0.0]", "[4.0,\n^2e7]", "an item of 'coordinates' must be from -1e+07 to 1e+07, not 20000000.0"},
      {"[4.0, 6.0, 0.0]", "[4.0, ^NaN]", "is not JSON: syntax error while parsing value - invalid literal; last read: '4.0, N'"},
      {"[4.0, 6.0, 0.0]", "[4.0, ^1e999]", "is not JSON: number overflow parsing '1e999'"},
      {"[4.0, 6.0, 0.0]", "^7", "'coordinates' must be a list, not 7"},
      {R"("type": "LineString")", R"("type": ^"Polygon")",
       "a feature must be a Point (a node), a LineString or a MultiLineString (an edge), not a Polygon"},
      {"\"features\": [\n    {", "\"features\": {\n    ^{",
       "is not JSON: syntax error while parsing object key - unexpected '{'; expected string literal"},
  };
  expect_faults(kNav2, faults);
  EXPECT_EQ(error(replaced(kNav2, "features", "futures")),
            ":1:1: is neither a graph of nav2's route server (GeoJSON with 'features') nor a LIF file (with 'layouts' or 'origins')");
  EXPECT_EQ(error(kNav2, {.vehicle = "truck", .map = std::nullopt}), ": a vehicle and a map are chosen from LIF files only");
}

TEST_F(GraphFile, IsRefusedWhenItIsNotJsonOrHoldsNothing) {
  EXPECT_EQ(error(""), ":1:1: is not JSON: syntax error while parsing value - unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(error("[]"), ":1:1: the file must be an object, not array");
  EXPECT_EQ(error("7"), ":1:1: the file must be an object, not 7");
  EXPECT_EQ(error(R"({"type": "FeatureCollection", "features": []})"), ":1:1: has no edges to score");
  EXPECT_EQ(error(R"({"layouts": []})"), ":1:1: has no nodes");
  EXPECT_THAT(error("{\"a\":\n \xff}"), testing::StartsWith(":2:2: is not JSON: "));
  EXPECT_THAT(error("{\"type\": \"Fea"), testing::StartsWith(":1:14: is not JSON: "));
}

TEST_F(GraphFile, NestedTooDeeplyIsRefusedAndHarmsNobody) {
  EXPECT_EQ(error(std::string(64, '[') + std::string(64, ']')), ":1:1: the file must be an object, not array");
  EXPECT_EQ(error(std::string(5'000'000, '[')), ":1:65: is nested deeper than 64 levels");
}

TEST_F(GraphFile, OfLifHasStraightEdgesAndTrajectories) {
  const Route route = read(kLif);
  EXPECT_TRUE(route.remarks.empty());
  ASSERT_EQ(route.graph.nodes.size(), 3u);
  EXPECT_EQ(route.graph.nodes[2].id, "C");
  EXPECT_EQ(route.graph.nodes[2].position, Eigen::Vector2d(4.0, 6.0));
  ASSERT_EQ(route.graph.edges.size(), 2u);
  EXPECT_EQ(route.graph.edges[0].id, "A-B");
  EXPECT_EQ(route.graph.edges[0].path, (Path{{1, 2, 0}, {4, 2, 0}}));
  const double back = 1.5 * kUp;
  EXPECT_EQ(route.graph.edges[1].path, (Path{{4, 2, 0}, {8, 2, 0}, {8, 2, back}, {4, 6, back}}));
}

TEST_F(GraphFile, OfLifIsReadInItsNewerVersionToo) {
  EXPECT_EQ(read(kNewerLif).graph.edges.at(0).path, (Path{{1, 2, 0}, {4, 2, 0}}));
  EXPECT_EQ(read(kNewerLif, {.vehicle = "Acme.Two", .map = "hall"}).graph.edges.size(), 1u);
}

TEST_F(GraphFile, OfLifTurnsTheRobotAsTheEdgeSays) {
  const auto yaw = [&](const std::string& said) {
    const std::string property = R"("rotationAllowed": false, "trajectory": null)";
    return read(replaced(kLif, property, said + ", " + property)).graph.edges.at(0).path.front().yaw;
  };
  EXPECT_EQ(yaw(R"("vehicleOrientation": 3)"), 3.0);
  EXPECT_EQ(yaw(R"("vehicleOrientation": 3, "orientationType": "TANGENTIAL")"), 3.0);
  EXPECT_EQ(yaw(R"("vehicleOrientation": 1, "orientationType": "GLOBAL")"), 1.0);
  const std::string upwards = replaced(kLif, R"("x": 4.0, "y": 2.0}, "vehicle)", R"("x": 1.0, "y": 4.0}, "vehicle)");
  const std::string property = R"("rotationAllowed": false, "trajectory": null)";
  EXPECT_EQ(read(replaced(upwards, property, R"("vehicleOrientation": 1, )" + property)).graph.edges.at(0).path.front().yaw, kUp + 1.0);
  EXPECT_EQ(read(replaced(upwards, property, R"("vehicleOrientation": 1, "orientationType": "GLOBAL", )" + property))
                .graph.edges.at(0)
                .path.front()
                .yaw,
            1.0);
}

TEST_F(GraphFile, OfLifRemarksOnWhatItDoesNotFollow) {
  const Route several = read(replaced(kNewerLif, "\"Two\"}]", R"("Two"}], "mobileRobotOrientations": [3.0, 0.0])"));
  EXPECT_EQ(several.graph.edges[0].path.front().yaw, 3.0);
  EXPECT_EQ(several.remarks, std::vector<std::string>{"edge 'A-B': may be driven in several orientations, but scored in the first"});
  EXPECT_EQ(read(replaced(kNewerLif, "\"Two\"}]", R"("Two"}], "physicalLineGuidedProperty": {"length": 4.0})")).remarks,
            std::vector<std::string>{"edge 'A-B': guided by a line on the floor, but scored straight"});
  EXPECT_EQ(read(replaced(kLif, R"([{"x": 4.0, "y": 2.0})", R"([{"x": 4.0, "y": 2.5})")).remarks,
            std::vector<std::string>{"edge 'B-C': scored along a trajectory that does not begin and end at its nodes"});
}

TEST_F(GraphFile, OfLifWantsAMapChosenWhereThereAreSeveral) {
  const std::string two = replaced(kLif, R"("nodeId": "C", "mapId": "hall")", R"("nodeId": "C", "mapId": "attic")");
  const Route hall = read(two, {.vehicle = std::nullopt, .map = "hall"});
  EXPECT_EQ(hall.graph.nodes.size(), 2u);
  EXPECT_EQ(hall.graph.edges.size(), 1u);
  EXPECT_EQ(hall.remarks, std::vector<std::string>{"edge 'B-C': left out, as one of its nodes lies on another map"});
  EXPECT_EQ(error(two, {.vehicle = std::nullopt, .map = "attic"}), ":1:1: has no edges to score");
  EXPECT_EQ(error(two, {.vehicle = std::nullopt, .map = "cellar"}), ":1:1: no node lies on the map 'cellar', but on 'attic', 'hall'");
}

TEST_F(GraphFile, OfLifWantsAVehicleChosenWhereTheyDriveDifferently) {
  const std::string second = R"([{"vehicleTypeId": "tug", "rotationAllowed": true, "vehicleOrientation": 3}, {"vehicleTypeId": "truck")";
  const std::string two = replaced(kLif, R"([{"vehicleTypeId": "truck", "rotationAllowed": false, "trajectory": null)",
                                   second + R"(, "rotationAllowed": false)");
  EXPECT_THAT(error(two), testing::EndsWith(": vehicles drive edge 'A-B' in different ways: choose a vehicle"));
  EXPECT_EQ(read(two, {.vehicle = "truck", .map = std::nullopt}).graph.edges.size(), 2u);
  const Route tug = read(two, {.vehicle = "tug", .map = std::nullopt});
  ASSERT_EQ(tug.graph.edges.size(), 1u);
  EXPECT_EQ(tug.graph.edges[0].path.front().yaw, 3.0);
  EXPECT_EQ(error(two, {.vehicle = "crane", .map = std::nullopt}), ":1:1: no edge is for the vehicle 'crane', but for 'truck', 'tug'");
  EXPECT_EQ(read(replaced(two, R"(, "vehicleOrientation": 3)", "")).graph.edges.size(), 2u);
}

TEST_F(GraphFile, OfLifIsRefusedWhereItIsWrong) {
  const Fault faults[] = {
      {R"("endNodeId": "C")", R"("endNodeId": ^"D")", "edge 'B-C' ends at node 'D', which there is none of"},
      {R"("startNodeId": "B")", R"("startNodeId": ^"D")", "edge 'B-C' begins at node 'D', which there is none of"},
      {R"("nodeId": "C")", R"("nodeId": ^"A")", "there is another node 'A'"},
      {R"("edgeId": "B-C")", R"("edgeId": ^"A-B")", "there is another edge 'A-B'"},
      {R"("nodeId": "C")", R"("nodeId": ^3)", "'nodeId' must be a text, not 3"},
      {R"({"x": 1.0, )", "^{", "missing key 'x'"},
      {R"("x": 1.0, )", R"("x": ^"1.0", )", R"('x' must be a number, not "1.0")"},
      {R"({"degree": 1, )", R"(^{"degree": 2, )", "the trajectory of edge 'B-C': 3 control points of degree 2 take 6 knots, not 5"},
      {R"({"degree": 1, )", R"(^{"degree": 33, )", "the trajectory of edge 'B-C': its degree must be from 1 to 32"},
      {R"("degree": 1, )", R"("degree": ^0, )", "'degree' must be a whole number from 1 to 2147483647, not 0"},
      {R"({"degree": 1, "knotVector": [0, 0, 0.5, 1, 1])", R"(^{"knotVector": [0, 0, 0.5, 0.4, 1])",
       "the trajectory of edge 'B-C': no knot may be less than the one before"},
      {R"("weight": 2.0)", R"("weight": ^0.0)", "'weight' must be greater than 0, not 0.0"},
      {R"([{"vehicleTypeId": "truck", "rotationAllowed": false, "trajectory": null}])", "^[]", "edge 'A-B' is for no vehicle"},
      {R"("rotationAllowed": false, "trajectory": null)", R"("orientationType": ^"SIDEWAYS")",
       "'orientationType' must be GLOBAL or TANGENTIAL, not 'SIDEWAYS'"},
      {R"("nodeId": "C", "mapId": "hall")", R"("nodeId": "C", "mapId": ^"attic")",
       "node 'C' lies on the map 'attic', node 'A' on 'hall': choose a map"},
  };
  expect_faults(kLif, faults);
  const Fault elsewhere{
      "\"origins\": [{\"originId\": \"gate\", \"layouts\": [{\n    \"layoutId\": \"ground\", \"layoutVersion\": \"1\",\n    \"nodes\": [\n "
      "     ",
      R"("origins": [{"layouts": [{"nodes": [{"nodeId": "P", "mapId": "hall", "nodePosition": {"x": 0, "y": 0}}], "edges": []}]},
                           {"originId": "gate", "layouts": [{"nodes": [^)",
      "node 'A' has another origin than node 'P': what lies where is not known"};
  expect_faults(kNewerLif, {&elsewhere, 1});
}

// A text with a few bytes changed, left out, put in or cut off, at random.
std::string damaged(std::string text, std::mt19937_64& engine) {
  const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine); };
  constexpr std::string_view kBytes = "{}[],:\"0123456789-.eE null\n\\\xff";
  for (std::size_t times = 1 + below(3); times > 0 && !text.empty(); --times) {
    const std::size_t at = below(text.size());
    const char byte = kBytes[below(kBytes.size())];
    switch (below(4)) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, 1 + below(3), byte);
        break;
      default:
        if (below(10) == 0) text.resize(at);
    }
  }
  return text;
}

TEST_F(GraphFile, DamagedAtRandomIsARouteOrAnInputError) {
  std::mt19937_64 engine(23);
  int refused = 0;
  for (const std::string good : {kNav2, kLif, kNewerLif}) {
    for (int i = 0; i < 700; ++i) {
      const std::string text = damaged(good, engine);
      try {
        EXPECT_FALSE(read(text).graph.edges.empty());
      } catch (const InputError& error) {
        ++refused;
        EXPECT_THAT(error.what(), testing::StartsWith((folder / "graph.json").string() + ':')) << text;
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace alignability
