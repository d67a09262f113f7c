// SPDX-License-Identifier: BSD-3-Clause
#include "python/arrays.hpp"

#include <limits>
#include <type_traits>

#include "core/range.hpp"

namespace alignability::python {
namespace {

static_assert(sizeof(Pose2) == 3 * sizeof(double) && std::is_standard_layout_v<Pose2>, "poses are shown to Python as rows of numbers");
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")).cast<std::string>(); }

// An array whose numbers are of one of these kinds: 'f' floats, 'i' and 'u' integers.
py::array array_of(const py::object& given, const std::string& kinds, const std::string& what) {
  py::array array = py::array::ensure(given);
  if (!array) throw py::type_error(what + " must be an array of numbers");
  if (kinds.find(array.dtype().kind()) == std::string::npos) {
    const auto type = py::str(array.dtype()).cast<std::string>();
    throw py::type_error(what + " must be " + (kinds == "f" ? "floats" : "numbers") + ", not " + type);
  }
  return array;
}

template <typename T>
using Contiguous = py::array_t<T, py::array::c_style | py::array::forcecast>;

template <typename T>
Contiguous<T> contiguous(const py::array& array) {
  Contiguous<T> converted = Contiguous<T>::ensure(array);
  if (!converted) throw py::error_already_set();
  return converted;
}

int count_of(py::ssize_t count, const std::string& what) {
  if (count > std::numeric_limits<int>::max()) throw py::value_error(what + " are too many");
  return static_cast<int>(count);
}

template <typename T>
py::array read_only(const T* data, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array array(py::dtype::of<T>(), std::move(shape), data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace

PointArray points_of(const py::object& points) {
  const py::array given = array_of(points, "f", "points");
  const bool is_organized = given.ndim() == 3;
  const py::ssize_t width = given.ndim() >= 2 ? given.shape(given.ndim() - 1) : 0;
  if (!((given.ndim() == 2 && (width == 2 || width == 3)) || (is_organized && width == 3))) {
    throw py::value_error("points must have the shape (N, 3), (N, 2) or (H, W, 3), not " + shape_text(given));
  }
  const Contiguous<float> values = contiguous<float>(given);
  Scan scan;
  scan.rings = is_organized ? count_of(given.shape(0), "points") : 1;
  scan.columns = count_of(given.shape(is_organized ? 1 : 0), "points");
  const auto count = static_cast<std::size_t>(values.size() / width);
  scan.points.reserve(count);
  for (const float* at = values.data(); scan.points.size() < count; at += width) {
    scan.points.emplace_back(at[0], at[1], width == 3 ? at[2] : 0.0f);
  }
  std::vector<py::ssize_t> shape(given.shape(), given.shape() + given.ndim() - 1);
  return {std::move(scan), std::move(shape), width == 2};
}

std::vector<Pose2> poses_of(const py::object& poses, const std::string& what) {
  const py::array given = array_of(poses, "fiu", what);
  if (given.ndim() != 2 || (given.shape(1) != 2 && given.shape(1) != 3)) {
    throw py::value_error(what + " must have the shape (N, 3) or (N, 2), not " + shape_text(given));
  }
  const Contiguous<double> values = contiguous<double>(given);
  const py::ssize_t width = given.shape(1);
  std::vector<Pose2> rows;
  rows.reserve(static_cast<std::size_t>(given.shape(0)));
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    const double* const at = values.data() + i * width;
    rows.push_back({at[0], at[1], width == 3 ? at[2] : 0.0});
    if (!kFinite.contains(at[0]) || !kFinite.contains(at[1]) || !kFinite.contains(rows.back().yaw)) {
      throw py::value_error(what + " must be finite; row " + std::to_string(i) + " is not");
    }
  }
  return rows;
}

py::array view_of(std::span<const Pose2> poses, py::handle owner) {
  return read_only(reinterpret_cast<const double*>(poses.data()), {static_cast<py::ssize_t>(poses.size()), 3}, owner);
}

py::array view_of(const Grid<float>& grid, py::handle owner) {
  return view_of(grid.values(), {grid.geometry().height, grid.geometry().width}, owner);
}

py::array view_of(std::span<const float> values, std::vector<py::ssize_t> shape, py::handle owner) {
  return read_only(values.data(), std::move(shape), owner);
}

py::array view_of(std::span<const int> values, std::vector<py::ssize_t> shape, py::handle owner) {
  return read_only(values.data(), std::move(shape), owner);
}

Grid<float> grid_of(const py::object& values, double resolution, const Eigen::Vector2d& origin, const std::string& what) {
  const py::array given = array_of(values, "f", what);
  if (given.ndim() != 2) throw py::value_error(what + " must have the shape (H, W), not " + shape_text(given));
  if (!kPositive.contains(resolution)) throw py::value_error("resolution must be " + kPositive.description());
  if (!origin.allFinite()) throw py::value_error("origin must be finite");
  const Contiguous<float> cells = contiguous<float>(given);
  const GridGeometry geometry{.resolution = resolution,
                              .origin = origin,
                              .width = count_of(given.shape(1), what + "'s columns"),
                              .height = count_of(given.shape(0), what + "'s rows")};
  return {geometry, std::vector<float>(cells.data(), cells.data() + cells.size())};
}

}  // namespace alignability::python
