// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "costmap/grid.hpp"
#include "lidar/scan.hpp"

namespace alignability::python {

namespace py = pybind11;

/// An array of points as a scan.
struct PointArray {
  Scan scan;
  std::vector<py::ssize_t> shape;  ///< of the array, but for its last axis
  bool is_flat = false;            ///< of two coordinates
};

/// Points [m], copied into floats of 32 bits: (N, 3), (N, 2) with z = 0, or (H, W, 3), which is organized, a row a ring. Throws a TypeError
/// for what holds no floats (integers too, which may be millimetres), and a ValueError for other shapes.
PointArray points_of(const py::object& points);

/// Rows x, y, yaw, or x, y with yaw 0; `what` names them in errors. Throws as points_of does, but takes integers.
std::vector<Pose2> poses_of(const py::object& poses, const std::string& what);

/// Rows of float64 that the owner keeps; not to be written to. The memory must last and stay as long as the owner.
py::array view_of(std::span<const Pose2> poses, py::handle owner);
/// Likewise rows of float32.
py::array view_of(const Grid<float>& grid, py::handle owner);
py::array view_of(std::span<const float> values, std::vector<py::ssize_t> shape, py::handle owner);
py::array view_of(std::span<const int> values, std::vector<py::ssize_t> shape, py::handle owner);

/// A copy of an array (H, W) of floats, row 0 at the bottom (min y), with its cells of `resolution` [m]. Throws as points_of does.
Grid<float> grid_of(const py::object& values, double resolution, const Eigen::Vector2d& origin, const std::string& what);

}  // namespace alignability::python
