// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan_file.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "lidar/bin_file.hpp"
#include "lidar/pcd_file.hpp"
#include "lidar/ply_file.hpp"

namespace alignability {
namespace {

static_assert(std::endian::native == std::endian::little, "points are written as they stand in memory, and PCD is little-endian");

constexpr std::uintmax_t kLargestFile = std::uintmax_t{4} << 30;

// The first word of the first line that is no comment.
std::string_view first_word(std::string_view bytes) {
  while (bytes.starts_with('#')) bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size() - 1) + 1);
  return bytes.substr(0, bytes.find_first_of(" \t\r\n"));
}

bool is_ply(std::string_view bytes) { return first_word(bytes) == "ply"; }

bool is_pcd(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  return word == "VERSION" || word == "FIELDS";
}

detail::OrderedCloud read(const std::filesystem::path& file) {
  const std::string bytes = read_file(file, kLargestFile);
  if (is_pcd(bytes)) return detail::parse_pcd(bytes, file);
  detail::OrderedCloud read;
  if (is_ply(bytes)) {
    read.cloud = detail::parse_ply(bytes, file);
  } else if (detail::is_bin_file(file)) {
    read.cloud.points = detail::parse_bin(bytes, file);
  } else {
    throw InputError(file, "is neither a PCD nor a PLY file, nor has it the extension .bin");
  }
  read.columns = static_cast<int>(read.cloud.points.size());
  return read;
}

}  // namespace

Scan read_scan_file(const std::filesystem::path& file) {
  detail::OrderedCloud ordered = read(file);
  return {.points = std::move(ordered.cloud.points), .rings = ordered.rings, .columns = ordered.columns};
}

PointCloud read_cloud_file(const std::filesystem::path& file) { return read(file).cloud; }

bool is_cloud_file(std::string_view head, const std::filesystem::path& file) {
  return is_pcd(head) || (is_ply(head) && !detail::declares_faces(head, file)) || detail::is_bin_file(file);
}

void write_pcd(const Scan& scan, const std::filesystem::path& file) {
  const std::string header =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
      std::to_string(scan.columns) + "\nHEIGHT " + std::to_string(scan.rings) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
      std::to_string(scan.points.size()) + "\nDATA binary\n";
  AtomicFile output(file);
  output.write(header);
  output.write({reinterpret_cast<const char*>(scan.points.data()), scan.points.size() * sizeof(scan.points[0])});
  output.commit();
}

}  // namespace alignability
