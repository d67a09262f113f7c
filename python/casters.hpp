// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Included wherever such types pass to or from Python, so that all files convert them alike.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "alignability/alignability.hpp"
#include "core/pose.hpp"
#include "costmap/grid.hpp"
#include "lidar/site.hpp"
#include "localization/localizer.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::python {

/// The names that values of an enumeration have in Python, and in files.
template <typename Enum>
struct Names;

template <>
struct Names<Engine> {
  static constexpr std::pair<const char*, Engine> kAll[] = {{"native", Engine::native}, {"pcl", Engine::pcl}};
};
template <>
struct Names<Dimensions> {
  static constexpr std::pair<const char*, Dimensions> kAll[] = {
      {"automatic", Dimensions::automatic}, {"two", Dimensions::two}, {"three", Dimensions::three}};
};
template <>
struct Names<Moment> {
  static constexpr std::pair<const char*, Moment> kAll[] = {{"about_origin", Moment::about_origin}, {"about_mean", Moment::about_mean}};
};
template <>
struct Names<Reading> {
  static constexpr std::pair<const char*, Reading> kAll[] = {
      {"centred", Reading::centred}, {"voxel", Reading::voxel}, {"robust", Reading::robust}, {"information", Reading::information}};
};
template <>
struct Names<SdfGeometry> {
  static constexpr std::pair<const char*, SdfGeometry> kAll[] = {{"visual", SdfGeometry::visual}, {"collision", SdfGeometry::collision}};
};
template <>
struct Names<UpAxis> {
  static constexpr std::pair<const char*, UpAxis> kAll[] = {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}};
};
template <>
struct Names<MotionSpace> {
  static constexpr std::pair<const char*, MotionSpace> kAll[] = {
      {"r2", MotionSpace::r2}, {"se2", MotionSpace::se2}, {"dubins", MotionSpace::dubins}, {"reeds_shepp", MotionSpace::reeds_shepp}};
};
template <>
struct Names<UnknownPolicy> {
  static constexpr std::pair<const char*, UnknownPolicy> kAll[] = {
      {"risky", UnknownPolicy::risky}, {"neutral", UnknownPolicy::neutral}, {"blocked", UnknownPolicy::blocked}};
};
template <>
struct Names<Localizer> {
  static constexpr const auto& kAll = kLocalizers;
};

template <typename Enum, typename = void>
inline constexpr bool kHasNames = false;
template <typename Enum>
inline constexpr bool kHasNames<Enum, std::void_t<decltype(Names<Enum>::kAll)>> = true;

/// "'a', 'b' or 'c'".
template <typename Enum>
std::string names_of() {
  std::string text;
  std::size_t left = std::size(Names<Enum>::kAll);
  for (const auto& named : Names<Enum>::kAll) {
    text.append("'").append(named.first).append("'");
    --left;
    if (left > 0) text.append(left == 1 ? " or " : ", ");
  }
  return text;
}

}  // namespace alignability::python

namespace pybind11::detail {

/// An enumeration is its name. Another string is a ValueError that lists the names.
template <typename Enum>
struct type_caster<Enum, std::enable_if_t<alignability::python::kHasNames<Enum>>> {
  PYBIND11_TYPE_CASTER(Enum, const_name("str"));

  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    const auto given = source.cast<std::string>();
    for (const auto& named : alignability::python::Names<Enum>::kAll) {
      if (given != named.first) continue;
      value = named.second;
      return true;
    }
    std::string message("must be ");
    message.append(alignability::python::names_of<Enum>()).append(", not '").append(given).append("'");
    throw value_error(message);
  }

  static handle cast(Enum source, return_value_policy, handle) {
    for (const auto& named : alignability::python::Names<Enum>::kAll) {
      if (named.second == source) return str(named.first).release();
    }
    return none().release();
  }
};

/// A pose is a tuple (x, y, yaw); any three numbers in a row make one.
template <>
struct type_caster<alignability::Pose2> {
  PYBIND11_TYPE_CASTER(alignability::Pose2, const_name("tuple[float, float, float]"));

  bool load(handle source, bool convert) {
    make_caster<std::array<double, 3>> numbers;
    // A sequence to pybind11, which an array is not.
    const object values = isinstance<array>(source) ? object(source.attr("tolist")()) : reinterpret_borrow<object>(source);
    if (!numbers.load(values, convert)) return false;
    const auto& [x, y, yaw] = cast_op<std::array<double, 3>&>(numbers);
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(yaw)) throw value_error("must be finite");
    value = {x, y, yaw};
    return true;
  }

  static handle cast(const alignability::Pose2& pose, return_value_policy, handle) {
    return make_tuple(pose.x, pose.y, pose.yaw).release();
  }
};

/// A cell is a tuple (column, row).
template <>
struct type_caster<alignability::Cell> {
  PYBIND11_TYPE_CASTER(alignability::Cell, const_name("tuple[int, int]"));

  bool load(handle source, bool convert) {
    make_caster<std::pair<int, int>> numbers;
    if (!numbers.load(source, convert)) return false;
    const auto [x, y] = cast_op<std::pair<int, int>>(numbers);
    value = {x, y};
    return true;
  }

  static handle cast(const alignability::Cell& cell, return_value_policy, handle) { return make_tuple(cell.x, cell.y).release(); }
};

}  // namespace pybind11::detail
