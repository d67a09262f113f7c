// SPDX-License-Identifier: BSD-3-Clause
#include "planner/route_file.hpp"

#include <algorithm>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "planner/route_formats.hpp"

namespace alignability {
namespace {

constexpr std::uintmax_t kLargestTable = 32u << 20;
constexpr double kLongestPath = 1e5;  // [m]

Route parse_graph(const std::filesystem::path& file, const RouteFileOptions& options) {
  const detail::JsonValue root = detail::JsonValue::from_file(file);
  if (root.find("layouts") || root.find("origins")) return detail::parse_lif(root, options);
  const auto type = root.find("type");
  if (!type || !root.find("features")) {
    root.fail("is neither a graph of nav2's route server (GeoJSON with 'features') nor a LIF file (with 'layouts' or 'origins')");
  }
  if (options.vehicle || options.map) throw InputError(file, "a vehicle and a map are chosen from LIF files only");
  return detail::parse_nav2_graph(root);
}

// What is longer was hardly meant in metres, and its figures and pictures would take for ever.
void check_length(const std::vector<Pose2>& path, const std::string& name, const std::filesystem::path& file) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1].position() - path[i].position()).norm();
  if (length > kLongestPath) {
    throw InputError(file, name + " is " + to_text(std::round(length)) + " m long; at most " + to_text(kLongestPath) + " m are scored");
  }
}

}  // namespace

Route read_route(const std::filesystem::path& file, const RouteFileOptions& options) {
  const std::string extension = file.extension().string();
  const bool is_table = extension == ".csv" || extension == ".txt";
  if (!is_table && extension != ".geojson" && extension != ".json" && extension != ".lif") {
    throw InputError(file, "is no route: a path is .csv or .txt, a graph .geojson, .json or .lif");
  }
  if (is_table && (options.vehicle || options.map)) throw InputError(file, "a vehicle and a map are chosen from LIF files only");
  const Route route = is_table ? detail::parse_path_table(read_file(file, kLargestTable), file) : parse_graph(file, options);
  check_length(route.path, "the path", file);
  for (const RouteEdge& edge : route.graph.edges) check_length(edge.path, "edge '" + edge.id + '\'', file);
  return route;
}

}  // namespace alignability
