// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/input_error.hpp"
#include "lidar/lidar_model.hpp"
#include "lidar/primitives.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability::test {

/// Writes a file of the folder, whose own folders are made where they are missing.
inline std::filesystem::path write(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  std::filesystem::create_directories((folder / name).parent_path());
  return folder.write(name, bytes);
}

/// What an InputError says, without the folder that the file is in; "" when `call` throws none.
template <typename Call>
std::string fault_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    const std::string folder = error.file().parent_path().string() + "/";
    const std::string text = error.what();
    return text.starts_with(folder) ? text.substr(folder.size()) : text;
  }
  return "";
}

inline TriangleMesh moved(const TriangleMesh& mesh, double x, double y, double z) {
  return transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(x, y, z)));
}

/// Enclosed volume [m³], negative when the triangles face inwards.
inline double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].cast<double>().dot(mesh.vertices[b].cast<double>().cross(mesh.vertices[c].cast<double>())) / 6.0;
  }
  return sum;
}

/// A sensor of few beams: three rings, twelve columns, level, noise-free.
inline LidarModel small_lidar() {
  LidarModel model;
  model.elevations = {-0.3, 0.0, 0.3};
  model.sectors = {{.min = -std::numbers::pi, .max = std::numbers::pi, .columns = 12}};
  model.range_min = 0.5;
  model.range_max = 50.0;
  model.rate = 10.0;
  return model;
}

}  // namespace alignability::test
