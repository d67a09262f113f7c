// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/bin_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "core/input_error.hpp"
#include "lidar/point_table.hpp"

namespace alignability::detail {
namespace {

constexpr std::size_t kRowBytes = 4 * sizeof(float);
// Coordinates [m] that a lidar measures, where they are not 0. Floats with their bytes in the wrong order are hardly ever among them.
constexpr float kFarthest = 1e4f;
constexpr float kNearest = 1e-20f;

bool measurable(float coordinate) {
  const float distance = std::abs(coordinate);
  return std::isnan(coordinate) || distance == 0.0f || (distance >= kNearest && distance <= kFarthest);
}

}  // namespace

bool is_bin_file(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".bin";
}

std::vector<Eigen::Vector3f> parse_bin(std::string_view bytes, const std::filesystem::path& file) {
  if (bytes.empty()) throw InputError(file, "holds no points");
  if (bytes.size() % kRowBytes != 0) {
    throw InputError(file, "is " + std::to_string(bytes.size()) + " bytes long; x, y, z and intensity of a point take " +
                               std::to_string(kRowBytes) + ", so it is cut short or no Velodyne file");
  }
  const std::size_t rows = bytes.size() / kRowBytes;
  if (rows > kMostPoints) {
    throw InputError(file, "has " + std::to_string(rows) + " points; at most " + std::to_string(kMostPoints) + " are read");
  }
  PointTable table{.file = file, .rows = rows, .row_bytes = kRowBytes, .row_values = 4, .xyz = {}, .normal = {}};
  for (std::size_t axis = 0; axis < 3; ++axis) table.xyz[axis] = {.byte = axis * sizeof(float), .value = axis};
  std::vector<Eigen::Vector3f> points = decode_binary(table, bytes, std::endian::little).points;
  for (std::size_t i = 0; i < rows; ++i) {
    if (std::ranges::all_of(points[i], measurable)) continue;
    throw InputError(file,
                     "point " + std::to_string(i) + ", counted from 0, lies where no lidar measures: these are no little-endian floats");
  }
  return points;
}

}  // namespace alignability::detail
