// SPDX-License-Identifier: BSD-3-Clause
#include "python/scene.hpp"

#include "lidar/scan_file.hpp"
#include "lidar/simulate_scan.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/keywords.hpp"
#include "python/long_work.hpp"

namespace alignability::python {
namespace {

const Keywords<SiteOptions>& keywords() {
  static const auto* const all = new Keywords<SiteOptions>(Keywords<SiteOptions>()
                                                               .add(
                                                                   "model_paths", [](auto& o) -> auto& { return o.world.model_paths; })
                                                               .add(
                                                                   "geometry", [](auto& o) -> auto& { return o.world.geometry; })
                                                               .add(
                                                                   "unit", [](auto& o) -> auto& { return o.unit; })
                                                               .add(
                                                                   "up_axis", [](auto& o) -> auto& { return o.up_axis; })
                                                               .add(
                                                                   "level", [](auto& o) -> auto& { return o.level; })
                                                               .add(
                                                                   "thinning", [](auto& o) -> auto& { return o.discs.thinning; }));
  return *all;
}

Scene load(const std::filesystem::path& path, const py::kwargs& given) {
  const SiteOptions options = keywords().read({}, given, "load");
  LoadedScene loaded = LongWork().run([&](const std::stop_token&) { return load_scene(path, options); });
  warn(loaded.warnings);
  return std::move(loaded.scene);
}

// Rings and columns where the sensor has them, else a row of points. It owns the points.
py::array array_of(const Scan& scan) {
  const auto rings = static_cast<py::ssize_t>(scan.rings);
  std::vector<py::ssize_t> shape{rings, static_cast<py::ssize_t>(scan.columns), 3};
  if (!scan.organized()) shape.erase(shape.begin());
  return py::array(py::dtype::of<float>(), std::move(shape), scan.points.empty() ? nullptr : scan.points.front().data());
}

py::array simulate(const SceneOrFile& scene, const std::filesystem::path& sensor, const Pose2& pose, std::optional<double> range_max,
                   double floor, std::optional<std::uint64_t> seed) {
  std::vector<std::string> warnings;
  const Scan scan = LongWork().run([&](const std::stop_token&) {
    const SensorRig rig = read_sensor_rig(sensor);
    const LoadedScene loaded = load_scene(scene);
    warnings = loaded.warnings;
    Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
    T_map_base.translation() << pose.x, pose.y, floor;
    T_map_base.rotate(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
    const auto noise = seed ? std::optional(NoiseKey{.seed = *seed}) : std::nullopt;
    return simulate_rig_scan(loaded.scene, rig, T_map_base, {.range_max = range_max}, noise);
  });
  warn(warnings);
  return array_of(scan);
}

}  // namespace

LoadedScene load_scene(const std::filesystem::path& file, const SiteOptions& options) {
  Site site = read_site(file, options);
  return {Scene(std::move(site.meshes), std::move(site.discs)), std::move(site.warnings)};
}

LoadedScene load_scene(const SceneOrFile& scene) {
  if (const auto* const file = std::get_if<std::filesystem::path>(&scene)) return load_scene(*file, {});
  return {std::get<Scene>(scene)};
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  }
}

void bind_scene(py::module_& module) {
  py::class_<Scene> bound(module, "Scene", "Surfaces that lidars see: an SDF world or model, a mesh or a point cloud.");
  {
    py::options told;
    told.disable_function_signatures();  // the text begins with one, which can be inspected
    bound.def_static(
        "load", &load, py::arg("path"),
        ("load(path, *, " + keywords().text_of({}) +
         ")\n--\n\nReads a site. `unit`, `up_axis` are for meshes and clouds, `level`, `thinning` for clouds. What is left out "
         "of it is warned of. Raises InputError.")
            .c_str());
  }
  module.def(
      "read_scan", [](const std::filesystem::path& path) { return array_of(read_scan_file(path)); }, py::arg("path"),
      "The points of a PCD, PLY or .bin file: (H, W, 3) of float32 where the file is organized, else (N, 3). Raises InputError.");
  module.def("simulate_scan", &simulate, py::arg("scene"), py::arg("sensor"), py::arg("pose"), py::kw_only(),
             py::arg("range_max") = py::none(), py::arg("floor") = 0.0, py::arg("seed") = py::none(),
             "What the sensor of a file sees where base_link stands at (x, y, yaw) of a Scene or its file: (H, W, 3) of float32 [m] in "
             "the lidar's frame, or (N, 3) in base_link of several lidars; NaN is no return. Ranges have noise where there is a seed.");
}

}  // namespace alignability::python
