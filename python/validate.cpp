// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "core/input_error.hpp"
#include "core/range.hpp"
#include "localization/drive_file.hpp"
#include "localization/survey.hpp"
#include "localization/trials.hpp"
#include "localization/validation.hpp"
#include "planner/plan.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/casters.hpp"
#include "python/long_work.hpp"
#include "python/problem.hpp"
#include "python/scene.hpp"

namespace alignability::python {
namespace {

// How one localizer fared on one run.
struct Run {
  std::vector<double> seconds;
  std::vector<double> s;
  std::vector<Pose2> truth;
  std::vector<Pose2> estimates;
  std::vector<double> errors;
};

// Everything of one localizer.
struct LocalizerValidation {
  Validation validation;
  std::vector<std::string> names;  // of the paths
  std::vector<std::vector<std::shared_ptr<Run>>> runs;
  GridGeometry cells;
};

// What is told of a cell, a row of an array with such columns.
struct CellRow {
  double x;
  double y;
  double error;
  double growth;
  double metres;
};

const std::filesystem::path& named(const std::optional<std::filesystem::path>& path, const char* key, const Problem& problem) {
  if (path) return *path;
  const std::string message = std::string("driving needs the key '") + key + "': a file";
  if (problem.file.file.empty()) throw std::invalid_argument(message);
  throw InputError(problem.file.file, message);
}

std::vector<DrivenPath> paths_of(const py::object& given) {
  if (!py::hasattr(given, "keys")) throw py::type_error("paths must be a dict of names and poses");
  std::vector<DrivenPath> paths;
  for (const auto& [name, poses] : py::dict(given)) {
    if (!py::isinstance<py::str>(name)) throw py::type_error("the names of paths must be strings");
    const auto text = name.cast<std::string>();
    paths.push_back({text, poses_of(py::reinterpret_borrow<py::object>(poses), "paths['" + text + "']"), {}});
    if (paths.back().path.empty()) throw py::value_error("paths['" + text + "'] must have a pose at least");
  }
  if (paths.empty()) throw py::value_error("paths must name a path at least");
  return paths;
}

std::shared_ptr<Run> run_of(const Drive& drive, std::size_t localizer) {
  auto run = std::make_shared<Run>();
  for (const DriveSample& sample : drive) {
    run->seconds.push_back(sample.truth.seconds);
    run->s.push_back(sample.truth.s);
    run->truth.push_back(sample.truth.pose);
    run->estimates.push_back(sample.estimates[localizer]);
    run->errors.push_back(sample.error(localizer));
  }
  return run;
}

// As the program's `validate path` does it.
std::vector<LocalizerValidation> drive_and_validate(const Problem& problem, std::vector<DrivenPath> paths, TrialOptions trials,
                                                    const std::vector<Localizer>& localizers, std::vector<std::string>& warnings) {
  const ProblemFile& file = problem.file;
  const double floor = trials.drive.floor;
  trials.drive = read_drive_file(named(file.drive, "drive", problem));
  if (!localizers.empty()) trials.drive.localizers = localizers;
  trials.drive.range_max = file.range_max;
  trials.drive.floor = floor;
  const SensorRig sensor = read_sensor_rig(named(file.sensor, "sensor", problem));
  const LoadedScene site = load_scene(named(file.scene, "scene", problem), {});
  warnings = site.warnings;
  const std::vector<Eigen::Vector3f> cloud =
      survey(site.scene, problem.plan.occupancy, sensor,
             {.range_max = trials.drive.range_max, .floor = floor, .threads = trials.threads, .progress = {}, .stop = trials.stop});
  const LocalizationMap map(cloud, for_sensor(trials.drive.localizer, sensor), trials.drive.localizers);
  std::vector<std::vector<Pose2>> ways;
  for (const DrivenPath& path : paths) ways.push_back(path.path);
  std::vector<std::vector<Drive>> drives = drive_trials(site.scene, sensor, map, ways, trials);
  for (std::size_t i = 0; i < paths.size(); ++i) paths[i].runs = std::move(drives[i]);
  if (trials.stop.stop_requested()) throw Interrupted();

  const ClearanceMap clearance(problem.plan.occupancy);
  const ErrorReference reference{problem.plan.alignability, clearance, circumscribed_radius(problem.plan.query.robot)};
  std::vector<LocalizerValidation> validations;
  for (Validation& validation : validate(paths, trials.drive.localizers, reference)) {
    LocalizerValidation of{std::move(validation), {}, {}, problem.plan.alignability.geometry};
    for (const DrivenPath& path : paths) {
      of.names.push_back(path.name);
      std::vector<std::shared_ptr<Run>>& runs = of.runs.emplace_back();
      for (const Drive& drive : path.runs) runs.push_back(run_of(drive, validations.size()));
    }
    validations.push_back(std::move(of));
  }
  return validations;
}

std::vector<LocalizerValidation> validate_paths(const Problem& problem, const py::object& paths, int runs, std::uint64_t seed,
                                                const std::vector<Localizer>& localizers, double floor, int threads,
                                                const py::object& progress) {
  const Problem given = problem;
  std::vector<DrivenPath> ways = paths_of(paths);
  LongWork work(progress);
  TrialOptions trials;
  trials.drive.floor = floor;
  trials.runs = runs;
  trials.seed = seed;
  trials.threads = threads;
  trials.progress = work.progress();
  std::vector<std::string> warnings;
  std::vector<LocalizerValidation> validations = work.run([&](const std::stop_token& stop) {
    trials.stop = stop;
    return drive_and_validate(given, std::move(ways), std::move(trials), localizers, warnings);
  });
  warn(warnings);
  return validations;
}

py::array_t<double> numbers_of(const std::vector<double>& values, const py::object& owner) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data(), owner);
}

py::array_t<CellRow> cells_of(const LocalizerValidation& validation) {
  const std::vector<CellErrors>& cells = validation.validation.cells;
  py::array_t<CellRow> rows(static_cast<py::ssize_t>(cells.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d center = validation.cells.center(cells[i].cell);
    rows.mutable_data()[i] = {center.x(), center.y(), cells[i].error, cells[i].growth, cells[i].metres};
  }
  return rows;
}

template <typename Value>
py::dict by_path(const LocalizerValidation& validation, const std::vector<Value>& values) {
  py::dict named;
  for (std::size_t i = 0; i < values.size(); ++i) named[py::str(validation.names[i])] = py::cast(values[i]);
  return named;
}

py::dict rank_correlations(const LocalizerValidation& validation) {
  py::dict correlations;
  for (const Validation::OfLayer& of : validation.validation.layers) correlations[py::str(of.layer)] = py::cast(of.prediction.error);
  return correlations;
}

void bind_errors_of_paths(py::module_& module) {
  py::class_<Interval>(module, "Interval", "A figure, and from where to where it may as well have come out (95 %).")
      .def_readonly("value", &Interval::value)
      .def_readonly("low", &Interval::low)
      .def_readonly("high", &Interval::high)
      .def("__float__", [](const Interval& interval) { return interval.value; })
      .def("__repr__", [](const Interval& interval) {
        std::string text("<Interval ");
        text.append(to_text(interval.value)).append(" (").append(to_text(interval.low)).append(" to ").append(to_text(interval.high));
        return text.append(")>");
      });
  py::class_<PathErrors>(module, "PathErrors", "How far off a localizer was over several runs [m].")
      .def_readonly("mean", &PathErrors::mean)
      .def_readonly("p95", &PathErrors::p95)
      .def_readonly("max", &PathErrors::max)
      .def_readonly("goal", &PathErrors::goal)
      .def_readonly("lost", &PathErrors::lost, "Share of the runs in which it exceeded 0.5 m somewhere.")
      .def_readonly("unsafe", &PathErrors::unsafe, "Share of the scans where it exceeded the way to the nearest obstacle.");
}

void bind_run(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>> bound(module, "Run", "One drive along a path, a row a scan; arrays share its memory.");
  const auto add = [&bound](const char* name, std::vector<double> Run::*values, const char* doc) {
    bound.def_property_readonly(
        name, [values](const py::object& self) { return numbers_of(self.cast<const Run&>().*values, self); }, doc);
  };
  add("seconds", &Run::seconds, "(N,) since the start.");
  add("s", &Run::s, "(N,) arc length [m].");
  add("errors", &Run::errors, "(N,) between estimate and truth [m].");
  bound.def_property_readonly(
      "truth", [](const py::object& self) { return view_of(self.cast<const Run&>().truth, self); }, "(N, 3) of x, y [m], yaw [rad].");
  bound.def_property_readonly(
      "estimates", [](const py::object& self) { return view_of(self.cast<const Run&>().estimates, self); }, "(N, 3) likewise.");
}

}  // namespace

void bind_validate(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(CellRow, x, y, error, growth, metres);
  bind_errors_of_paths(module);
  bind_run(module);
  py::class_<LocalizerValidation>(module, "Validation", "How far off one localizer was on paths that were driven.")
      .def_property_readonly("localizer", [](const LocalizerValidation& of) { return of.validation.localizer; })
      .def_property_readonly(
          "errors", [](const LocalizerValidation& of) { return of.validation.errors; }, "Over all paths.")
      .def_property_readonly(
          "by_path", [](const LocalizerValidation& of) { return by_path(of, of.validation.by_path); }, "By the paths' names.")
      .def_property_readonly(
          "runs", [](const LocalizerValidation& of) { return by_path(of, of.runs); },
          "By the paths' names a list of what happened in each run.")
      .def_property_readonly("cells", &cells_of,
                             "A new structured array of the map's cells that were driven through: x, y, error, growth, metres.")
      .def_property_readonly(
          "rank_correlations", &rank_correlations,
          "By layer of the map, alpha and readings, how it ranks cells with the error in them: -1 where a greater reading "
          "always is a smaller error.");
  const TrialOptions defaults;
  module.def("validate", &validate_paths, py::arg("problem"), py::arg("paths"), py::kw_only(), py::arg("runs") = defaults.runs,
             py::arg("seed") = defaults.seed, py::arg("localizers") = py::list(), py::arg("floor") = defaults.drive.floor,
             py::arg("threads") = defaults.threads, py::arg("progress") = py::none(),
             "Drives simulated robots along paths, poses (N, 3) by name, and tells how far off their localizers are: a Validation of each. "
             "The problem names the scene, the sensor and what drives. `localizers` are ndt_mcl_sum, ndt_mcl_product, scan_matching, in "
             "place of those of the file. `progress(done, total)` is called as runs end, from another thread. Ctrl-C stops it. Raises "
             "InputError.");
}

}  // namespace alignability::python
