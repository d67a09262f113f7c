// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "core/input_error.hpp"
#include "core/range.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/heading_layers.hpp"
#include "costmap/map_server.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/casters.hpp"

namespace alignability::python {
namespace {

using ReleaseLock = py::call_guard<py::gil_scoped_release>;

// The name of which the files' names are made, whether or not it is given with the ending of one.
std::filesystem::path without_ending(const std::filesystem::path& file) {
  return file.extension() == ".yaml" ? std::filesystem::path(file).replace_extension() : file;
}

py::array_t<float> occupancy_array(const OccupancyMap& map) {
  const GridGeometry& geometry = map.geometry();
  py::array_t<float> array({geometry.height, geometry.width});
  float* const cells = array.mutable_data();
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    cells[i] = map.occupancy(geometry.cell_of(i)).value_or(std::numeric_limits<float>::quiet_NaN());
  }
  return array;
}

AlignabilityMap alignability_map_of(const py::object& alpha, double resolution, const Eigen::Vector2d& origin) {
  Grid<float> grid = grid_of(alpha, resolution, origin, "alpha");
  if (grid.values().empty()) throw py::value_error("alpha must have a cell at least");
  const auto is_valid = [](float value) { return std::isnan(value) || (value >= 0.0f && value <= 1.0f); };
  if (!std::ranges::all_of(grid.values(), is_valid)) throw py::value_error("alpha must be from 0 to 1, or NaN where it is not known");
  AlignabilityMap map;
  map.geometry = grid.geometry();
  map.layers.push_back({"alpha", std::move(grid)});
  return map;
}

py::array layer_of(const py::object& self, const std::string& name) {
  const auto& map = self.cast<const AlignabilityMap&>();
  const Grid<float>* const layer = map.find_layer(name);
  if (layer != nullptr) return view_of(*layer, self);
  std::vector<std::string> names;
  for (const AlignabilityMap::Layer& each : map.layers) names.push_back(each.name);
  throw py::key_error("there is no layer '" + name + "'" + did_you_mean(name, names));
}

std::string shown(const char* name, const GridGeometry& geometry) {
  std::string text("<");
  text.append(name).append(" of ").append(std::to_string(geometry.width)).append(" x ").append(std::to_string(geometry.height));
  return text.append(" cells of ").append(to_text(geometry.resolution)).append(" m>");
}

// What both maps have of their geometry.
template <typename Map, typename GeometryOf>
void add_geometry(py::class_<Map, std::shared_ptr<Map>>& bound, const char* name, GeometryOf geometry_of) {
  const std::string class_name = name;
  bound
      .def_property_readonly(
          "resolution", [=](const Map& map) { return geometry_of(map).resolution; }, "Side of a cell [m].")
      .def_property_readonly(
          "origin", [=](const Map& map) { return std::pair(geometry_of(map).origin.x(), geometry_of(map).origin.y()); },
          "(x, y) of the outer corner of cell [0, 0] in `map` [m].")
      .def_property_readonly(
          "shape", [=](const Map& map) { return std::pair(geometry_of(map).height, geometry_of(map).width); }, "(rows, columns).")
      .def("__repr__", [=](const Map& map) { return shown(class_name.c_str(), geometry_of(map)); });
}

void bind_occupancy(py::module_& module) {
  py::class_<OccupancyMap, std::shared_ptr<OccupancyMap>> bound(
      module, "OccupancyMap", "Whether cells are occupied: a grid whose row 0 is the bottom one (min y) and whose column 0 the left one.");
  add_geometry(bound, "OccupancyMap", [](const OccupancyMap& map) -> const GridGeometry& { return map.geometry(); });
  bound
      .def_static("load", &read_occupancy_map, py::arg("path"), ReleaseLock(),
                  "Reads a map_server map, NAME.yaml and the image that it names. Raises InputError.")
      .def_static(
          "from_array",
          [](const py::object& occupancy, double resolution, const Eigen::Vector2d& origin) {
            return OccupancyMap(grid_of(occupancy, resolution, origin, "occupancy"));
          },
          py::arg("occupancy"), py::arg("resolution"), py::arg("origin") = std::pair(0.0, 0.0),
          "Copies (rows, columns) of floats from 0, free, to 1, occupied; NaN is unknown. Free is at most 0.5.")
      .def_property_readonly("occupancy", &occupancy_array, "A new array (rows, columns) of float32 from 0 to 1; NaN is unknown.")
      .def(
          "save", [](const OccupancyMap& map, const std::filesystem::path& path) { write_occupancy_map(map, without_ending(path)); },
          py::arg("path"), ReleaseLock(), "Writes NAME.yaml and NAME.pgm, trinary; the ending .yaml may be given. Raises InputError.");
}

void bind_alignability(py::module_& module) {
  py::class_<AlignabilityMap, std::shared_ptr<AlignabilityMap>> bound(
      module, "AlignabilityMap",
      "Alignability per cell: a grid whose row 0 is the bottom one (min y) and whose column 0 the left one. It does not change.");
  add_geometry(bound, "AlignabilityMap", [](const AlignabilityMap& map) -> const GridGeometry& { return map.geometry; });
  bound.def_static("load", &read_alignability_map, py::arg("path"), ReleaseLock(),
                   "Reads NAME.yaml and the TIFF that it names. Raises InputError.");
  bound.def_static("from_array", &alignability_map_of, py::arg("alpha"), py::arg("resolution"), py::arg("origin") = std::pair(0.0, 0.0),
                   "Copies (rows, columns) of floats from 0 to 1; NaN is not evaluated.");
  bound.def_property_readonly(
      "alpha", [](const py::object& self) { return view_of(self.cast<const AlignabilityMap&>().alpha(), self); },
      "(rows, columns) of float32, NaN where not evaluated: a view of the map, not to be written to.");
  bound.def_property_readonly(
      "layers",
      [](const AlignabilityMap& map) {
        std::vector<std::string> names;
        for (const AlignabilityMap::Layer& layer : map.layers) names.push_back(layer.name);
        return names;
      },
      "The layers' names; the first is alpha.");
  bound.def("layer", &layer_of, py::arg("name"), "As alpha, of any layer. Raises KeyError.");
  bound.def_readonly("seed", &AlignabilityMap::seed)
      .def_readonly("options", &AlignabilityMap::options, "YAML text of the options it was made with.")
      .def_readonly("sensor", &AlignabilityMap::sensor, "The sensor file it was made with, verbatim.")
      .def_readonly("provenance", &AlignabilityMap::provenance, "YAML text: the files it was made from.");
  bound.def(
      "save", [](const AlignabilityMap& map, const std::filesystem::path& path) { write_alignability_map(map, without_ending(path)); },
      py::arg("path"), ReleaseLock(), "Writes NAME.yaml and NAME.tiff; the ending .yaml may be given. Raises InputError.");
}

}  // namespace

void bind_maps(py::module_& module) {
  bind_occupancy(module);
  bind_alignability(module);
}

}  // namespace alignability::python
