// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lidar/point_cloud.hpp"

namespace alignability::detail {

/// Where in a row of a point file a coordinate stands.
struct Coordinate {
  enum class Type { float32, float64 };

  Type type = Type::float32;
  std::size_t byte = 0;   // from the start of a binary row
  std::size_t value = 0;  // in an ASCII row, counted from 0
};

/// Points in a file, one a row, all rows alike: what PCD and PLY have in common.
struct PointTable {
  std::filesystem::path file;
  std::size_t rows = 0;
  std::size_t row_bytes = 0;
  std::size_t row_values = 0;
  std::array<Coordinate, 3> xyz;
  /// Nothing where the file has none, or not all three.
  std::optional<std::array<Coordinate, 3>> normal;
  /// Where the rows begin in the file, and on which line, counted from 1.
  std::size_t begin = 0;
  int first_line = 1;
};

/// What follows a table's last row: nothing but blank lines, or something else that is ignored.
enum class Remainder { none, anything };

/// A point, or normal, with a coordinate that is not a finite float is NaN in all three. Throws InputError when there are fewer rows than
/// declared.
PointCloud decode_binary(const PointTable& table, std::string_view bytes, std::endian order);
PointCloud decode_ascii(const PointTable& table, std::string_view bytes, Remainder remainder);
/// Of bytes in which not the rows but the columns follow one another, as in a compressed PCD. `xyz[i].byte` says where in a row a column
/// would stand, and so that column i begins at `rows * xyz[i].byte`; so does `normal`.
PointCloud decode_columns(const PointTable& table, std::string_view bytes);

/// Gathers where a table's coordinates stand, column by column as a header declares them.
class CoordinateColumns {
 public:
  /// The names of x, y, z and of the normal's.
  explicit CoordinateColumns(const std::array<std::string, 6>& names) : names_(names) {}

  bool has(const std::string& name) const { return std::ranges::find(names_, name) != names_.end(); }
  /// False where the name, one of them, was there before.
  bool put(const std::string& name, const Coordinate& coordinate);
  /// Into a table; false when x, y or z is missing.
  bool finish(PointTable& table) const;

 private:
  const std::array<std::string, 6>& names_;
  std::array<std::optional<Coordinate>, 6> found_;
};

/// A header's lines, one after the other.
class HeaderLines {
 public:
  HeaderLines(std::filesystem::path file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {}

  /// The words of the next line; none for a blank one. Throws InputError at the end of the file, and where a line has more than 64 KiB.
  std::vector<std::string> next();
  std::size_t position() const { return position_; }
  int line() const { return line_; }
  [[noreturn]] void fail(std::string_view message) const;
  /// A whole number from `min` to `max`, or InputError at this line.
  std::size_t number(const std::string& word, std::size_t min, std::size_t max) const;

 private:
  std::filesystem::path file_;
  std::string_view bytes_;
  std::size_t position_ = 0;
  int line_ = 0;
};

inline constexpr std::size_t kMostPoints = std::size_t{1} << 26;
inline constexpr std::size_t kMostRowBytes = std::size_t{1} << 16;

}  // namespace alignability::detail
