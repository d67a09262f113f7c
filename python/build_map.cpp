// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/build_map.hpp"

#include <memory>
#include <variant>

#include "costmap/map_server.hpp"
#include "python/bindings.hpp"
#include "python/long_work.hpp"
#include "python/scene.hpp"
#include "python/score_keywords.hpp"

namespace alignability::python {
namespace {

// What the function is told beside its arguments.
struct BuildOptions {
  MapOptions map;
  std::optional<int> headings;  // none: as many as the sensor needs
  py::object progress = py::none();
};

// Of a sensor that sees another thing at every heading, as the program has it.
constexpr int kUsualHeadings = 8;

using OccupancyOrFile = std::variant<std::filesystem::path, std::shared_ptr<OccupancyMap>>;

const Keywords<BuildOptions>& keywords() {
  static const auto* const all = [] {
    auto* const made = new Keywords<BuildOptions>;
    made->add(
            "resolution", [](auto& o) -> auto& { return o.map.resolution; })
        .add(
            "samples", [](auto& o) -> auto& { return o.map.samples; })
        .add(
            "range_max", [](auto& o) -> auto& { return o.map.range_max; })
        .add(
            "headings", [](auto& o) -> auto& { return o.headings; })
        .add(
            "floor", kFinite, [](auto& o) -> auto& { return o.map.floor; })
        .add(
            "seed", [](auto& o) -> auto& { return o.map.seed; })
        .add(
            "occupied_above", kShare, [](auto& o) -> auto& { return o.map.rule.occupied_above; })
        .add(
            "max_occupied_share", kShare, [](auto& o) -> auto& { return o.map.rule.max_occupied_share; })
        .add(
            "cells", [](auto& o) -> auto& { return o.map.cells; })
        .add(
            "checkpoint", [](auto& o) -> auto& { return o.map.checkpoint; })
        .add(
            "threads", [](auto& o) -> auto& { return o.map.threads; })
        .add(
            "progress", [](auto& o) -> auto& { return o.progress; });
    add_scoring(
        *made, [](BuildOptions & o) -> auto& { return o.map.alignability; });
    return made;
  }();
  return *all;
}

OccupancyMap occupancy_of(const OccupancyOrFile& occupancy) {
  if (const auto* const file = std::get_if<std::filesystem::path>(&occupancy)) return read_occupancy_map(*file);
  return *std::get<std::shared_ptr<OccupancyMap>>(occupancy);
}

// As the program writes it, of what was a file.
template <typename Variant>
void name_file(std::string& text, const char* key, const Variant& given) {
  const auto* const file = std::get_if<std::filesystem::path>(&given);
  if (file != nullptr) text.append(key).append(": ").append(file->filename().string()).append("\n");
}

std::string provenance(const SceneOrFile& scene, const OccupancyOrFile& occupancy, const std::filesystem::path& sensor) {
  std::string text;
  name_file(text, "scene", scene);
  name_file(text, "occupancy", occupancy);
  text.append("sensor: ").append(sensor.filename().string()).append("\n");
  return text.append("made_by: alignability " ALIGNABILITY_VERSION "\n");
}

std::shared_ptr<AlignabilityMap> build_map(const SceneOrFile& scene, const std::filesystem::path& sensor, const OccupancyOrFile& occupancy,
                                           const py::kwargs& given) {
  BuildOptions options = keywords().read({}, given, "build_map");
  LongWork work(options.progress);
  MapOptions map_options = options.map;
  map_options.progress = work.progress();
  std::vector<std::string> warnings;
  auto map = work.run([&](const std::stop_token& stop) {
    const SensorRig rig = read_sensor_rig(sensor);
    const OccupancyMap ground = occupancy_of(occupancy);
    LoadedScene site = load_scene(scene);
    warnings = std::move(site.warnings);
    map_options.headings = options.headings.value_or(rig.sees_all_around() ? 1 : kUsualHeadings);
    map_options.alignability = for_lidar(map_options.alignability, rig);
    map_options.stop = stop;
    auto built = std::make_shared<AlignabilityMap>(build_alignability_map(site.scene, ground, rig, map_options));
    built->provenance = provenance(scene, occupancy, sensor);
    return built;
  });
  warn(warnings);
  return map;
}

}  // namespace

void bind_build_map(py::module_& module) {
  py::options told;
  told.disable_function_signatures();  // the text begins with one, which can be inspected
  module.def("build_map", &build_map, py::arg("scene"), py::arg("sensor"), py::arg("occupancy"),
             ("build_map(scene, sensor, occupancy, *, " + keywords().text_of({}) +
              ")\n--\n\nThe alignability map of a site: of a Scene or its file, for the sensor of a file, on an OccupancyMap or its file. "
              "`headings` is 1, for a sensor that does not see all around 8, unless given. `cells` are those (column, row) to evaluate "
              "alone, `checkpoint` a file that keeps what is done. `progress(done, total)` is called as cells are done, from another "
              "thread. Ctrl-C stops it. Raises InputError, and ValueError for options out of range.")
                 .c_str());
}

}  // namespace alignability::python
