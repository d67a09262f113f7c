// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan_file.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/file.hpp"
#include "core/input_error.hpp"
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

}  // namespace

Scan read_scan_file(const std::filesystem::path& file) {
  const std::string bytes = read_file(file, kLargestFile);
  const std::string_view word = first_word(bytes);
  if (word == "ply") return detail::parse_ply(bytes, file);
  if (word == "VERSION" || word == "FIELDS") return detail::parse_pcd(bytes, file);
  throw InputError(file, "is neither a PCD nor a PLY file");
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
