// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "planner/drivable_area.hpp"
#include "planner/path_figures.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/keywords.hpp"
#include "python/problem.hpp"

namespace alignability::python {
namespace {

// Rows of numbers as `value_of` tells of poses, without the interpreter lock.
template <typename T, typename ValueOf>
py::array_t<T> each(std::size_t count, ValueOf value_of) {
  py::array_t<T> values(static_cast<py::ssize_t>(count));
  T* const first = values.mutable_data();
  const py::gil_scoped_release release;
  for (std::size_t i = 0; i < count; ++i) first[i] = value_of(i);
  return values;
}

// Where risk depends on yaw, places alone do not tell it.
std::vector<Pose2> poses_for(const RiskField& field, const py::object& given, const std::string& what) {
  std::vector<Pose2> poses = poses_of(given, what);
  if (field.has_headings() && py::array::ensure(given).shape(1) == 2) {
    throw py::value_error(what + " need a yaw, on which this risk depends: (N, 3)");
  }
  return poses;
}

void check_as_many(const std::vector<Pose2>& from, const std::vector<Pose2>& to) {
  if (from.size() != to.size()) {
    throw py::value_error("there are " + std::to_string(from.size()) + " poses to come from and " + std::to_string(to.size()) +
                          " to go to");
  }
}

py::array_t<double> risk(const RiskField& field, const py::object& given) {
  const std::vector<Pose2> poses = poses_for(field, given, "poses");
  return each<double>(poses.size(), [&](std::size_t i) { return field.risk(poses[i].x, poses[i].y, poses[i].yaw); });
}

py::array_t<double> alpha(const RiskField& field, const py::object& given) {
  const std::vector<Pose2> poses = poses_for(field, given, "poses");
  return each<double>(poses.size(), [&](std::size_t i) { return field.alpha(poses[i].x, poses[i].y, poses[i].yaw); });
}

py::array_t<double> integral(const RiskField& field, const py::object& begin, const py::object& end) {
  const std::vector<Pose2> from = poses_for(field, begin, "from_poses");
  const std::vector<Pose2> to = poses_for(field, end, "to_poses");
  check_as_many(from, to);
  return each<double>(from.size(), [&](std::size_t i) { return field.integral(from[i], to[i]); });
}

PathFigures measure_path(const RiskField& field, const py::object& path) {
  const std::vector<Pose2> poses = poses_for(field, path, "path");
  const py::gil_scoped_release release;
  return measure(std::span<const Pose2>(poses), field);
}

py::array_t<bool> contains(const DrivableArea& area, const py::object& given) {
  const std::vector<Pose2> poses = poses_of(given, "poses");
  return each<bool>(poses.size(), [&](std::size_t i) { return area.contains(poses[i]); });
}

py::array_t<bool> connects(const DrivableArea& area, const py::object& begin, const py::object& end) {
  const std::vector<Pose2> from = poses_of(begin, "from_poses");
  const std::vector<Pose2> to = poses_of(end, "to_poses");
  check_as_many(from, to);
  return each<bool>(from.size(), [&](std::size_t i) { return area.contains(from[i], to[i]); });
}

py::array_t<double> clearance(const DrivableArea& area, const py::object& given) {
  const std::vector<Pose2> poses = poses_of(given, "poses");
  return each<double>(poses.size(), [&](std::size_t i) { return area.clearance(poses[i]); });
}

std::shared_ptr<RiskField> field_of(const Problem& problem) {
  const PlanProblem& plan = problem.plan;
  return std::make_shared<RiskField>(plan.alignability, plan.occupancy, plan.query.risk);
}

std::shared_ptr<DrivableArea> area_of(const Problem& problem) {
  return std::make_shared<DrivableArea>(std::make_shared<ClearanceMap>(problem.plan.occupancy), field_of(problem),
                                        problem.plan.query.robot);
}

}  // namespace

void bind_risk(py::module_& module) {
  py::class_<RiskField, std::shared_ptr<RiskField>>(
      module, "RiskField",
      "The risk by place of a problem as it is when this is made; it does not change. Poses are "
      "(N, 3) of x, y [m], yaw [rad], or (N, 2) where the risk takes no notice of yaw.")
      .def(py::init(&field_of), py::arg("problem"), py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("has_headings", &RiskField::has_headings, "Whether it depends on yaw.")
      .def("risk", &risk, py::arg("poses"), "(N,) of risk, in [0, 1] where there is no other source than alignability.")
      .def("alpha", &alpha, py::arg("poses"), "(N,) of alpha, bilinear; NaN where a cell without a value has a part in it.")
      .def("integral", &integral, py::arg("from_poses"), py::arg("to_poses"),
           "(N,) of the integral of the risk [m] along the straight way from each pose to the other, exactly.")
      .def("measure", &measure_path, py::arg("path"), "The figures of a path, straight between its poses.");
  py::class_<DrivableArea, std::shared_ptr<DrivableArea>>(
      module, "DrivableArea", "Where the robot of a problem fits, as it is when this is made; it does not change. Exact, without sampling.")
      .def(py::init(&area_of), py::arg("problem"), py::call_guard<py::gil_scoped_release>())
      .def("contains", &contains, py::arg("poses"), "(N,) of bool: whether the robot may be there.")
      .def("connects", &connects, py::arg("from_poses"), py::arg("to_poses"),
           "(N,) of bool: whether it may be everywhere on the straight way between two, turning evenly.")
      .def("clearance", &clearance, py::arg("poses"), "(N,) [m] between the robot's edge and the nearest obstacle.");
}

}  // namespace alignability::python
