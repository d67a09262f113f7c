// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "core/range.hpp"
#include "lidar/simulate_scan.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/score_keywords.hpp"

namespace alignability::python {
namespace {

// A scan scored, and the shape that its points came in.
struct Score {
  ScoredScan scan;
  std::vector<py::ssize_t> shape;
  std::vector<Reading> readings;

  const Alignability& alignability() const { return scan.alignability; }
};

const Keywords<AlignabilityOptions>& keywords() {
  static const auto* const all = [] {
    auto* const made = new Keywords<AlignabilityOptions>;
    made->add(
            "range_min", kNotNegative, [](auto& o) -> auto& { return o.segmentation.range_min; })
        .add(
            "range_stddev", kPositive, [](auto& o) -> auto& { return o.range_stddev; })
        .add(
            "dimensions", [](auto& o) -> auto& { return o.segmentation.dimensions; });
    add_scoring(
        *made, [](AlignabilityOptions & o) -> auto& { return o; });
    return made;
  }();
  return *all;
}

Scan told_apart_by(const SensorRig& sensor, Scan scan) {
  try {
    return told_apart(std::move(scan), sensor);
  } catch (const std::invalid_argument& error) {
    throw py::value_error(std::string("points: the scan ") + error.what());
  }
}

Score score_points(const py::object& points, const std::optional<std::filesystem::path>& sensor, const py::kwargs& given) {
  PointArray array = points_of(points);
  AlignabilityOptions options;
  if (sensor) {
    const SensorRig rig = read_sensor_rig(*sensor);
    options = for_lidar(options, rig);
    array.scan = told_apart_by(rig, std::move(array.scan));
  }
  if (array.is_flat) options.segmentation.dimensions = Dimensions::two;
  options = keywords().read(std::move(options), given, "score");
  if (array.is_flat && options.segmentation.dimensions == Dimensions::three) {
    throw py::value_error("dimensions cannot be 'three' for points of two coordinates");
  }
  const py::gil_scoped_release release;
  return {score(array.scan, options), std::move(array.shape), options.readings};
}

py::dict readings_of(const Score& score) {
  py::dict readings;
  for (const Reading reading : score.readings) {
    readings[py::str(std::string(to_string(reading)))] = value_of(reading, score.alignability().readings);
  }
  return readings;
}

py::array normals_of(const py::object& self) {
  const auto& score = self.cast<const Score&>();
  std::vector<py::ssize_t> shape = score.shape;
  shape.push_back(3);
  const float* const first = score.scan.normals.empty() ? nullptr : score.scan.normals.front().data();
  return view_of(std::span(first, 3 * score.scan.normals.size()), std::move(shape), self);
}

py::array planes_of(const py::object& self) {
  const auto& score = self.cast<const Score&>();
  return view_of(score.scan.plane_of_point, score.shape, self);
}

std::string shown(const Score& score) {
  const Alignability& at = score.alignability();
  return "<Score alpha " + to_text(at.alpha) + ", " + std::to_string(at.planes_kept) + " planes of " + std::to_string(at.points) +
         " points>";
}

}  // namespace

void bind_score(py::module_& module) {
  py::class_<Score>(module, "Score", "How well a scan constrains alignment, and how that came about.")
      .def_property_readonly(
          "alpha", [](const Score& s) { return s.alignability().alpha; }, "From 0 to 1; 0 when no plane is kept.")
      .def_property_readonly(
          "dimensions", [](const Score& s) { return s.alignability().dimensions; }, "2 where planes are lines.")
      .def_property_readonly(
          "eigenvalues", [](const Score& s) { return s.alignability().eigenvalues; },
          "Of the normals' second moment, descending; of two dimensions the third is NaN.")
      .def_property_readonly(
          "weakest_direction", [](const Score& s) { return s.alignability().weakest_direction; },
          "Unit vector in the frame of the scan, of either sign; 0 when no plane is kept.")
      .def_property_readonly("planes_found", [](const Score& s) { return s.alignability().planes_found; })
      .def_property_readonly("planes_kept", [](const Score& s) { return s.alignability().planes_kept; })
      .def_property_readonly(
          "points", [](const Score& s) { return s.alignability().points; }, "Those that were not dropped.")
      .def_property_readonly("readings", &readings_of, "By name those asked for; of `information` the least [1/m²].")
      .def_property_readonly("plane_of_point", &planes_of, "The kept plane of each point, from 0; -1 is none. A view, as points came.")
      .def_property_readonly("normals", &normals_of, "Of each point, turned to the sensor; NaN where dropped. A view, as points came.")
      .def("__repr__", &shown);
  py::options told;
  told.disable_function_signatures();  // the text begins with one, which can be inspected
  module.def(
      "score", &score_points, py::arg("points"), py::kw_only(), py::arg("sensor") = py::none(),
      ("score(points, *, sensor=None, " + keywords().text_of({}) +
       ")\n--\n\nThe alignability of a scan in metres, in the lidar's frame: (N, 3); (H, W, 3), organized, a row a ring; or (N, 2) of "
       "a 2D lidar. NaN is no return. Points are copied into float32. `sensor` is a file that says range_min, range_stddev, "
       "dimensions and mounts where they are not given.")
          .c_str());
}

}  // namespace alignability::python
