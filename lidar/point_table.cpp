// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/point_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

template <typename Float, typename Bits>
Float load(const char* bytes, std::endian order) {
  std::array<char, sizeof(Bits)> copy;
  std::memcpy(copy.data(), bytes, copy.size());
  if (order != std::endian::native) std::ranges::reverse(copy);
  return std::bit_cast<Float>(copy);
}

float load(const char* bytes, Coordinate::Type type, std::endian order) {
  if (type == Coordinate::Type::float32) return load<float, std::uint32_t>(bytes, order);
  return static_cast<float>(load<double, std::uint64_t>(bytes, order));
}

Eigen::Vector3f finite_or_nan(const Eigen::Vector3f& point) {
  return point.allFinite() ? point : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
}

std::string_view take_line(std::string_view bytes, std::size_t& position) {
  const std::size_t end = std::min(bytes.find('\n', position), bytes.size());
  const std::string_view line = bytes.substr(position, end - position);
  position = std::min(end + 1, bytes.size());
  return line;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;
       begin = line.find_first_not_of(kBlanks, begin)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

bool parse(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return false;
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  return error == std::errc{} || error == std::errc::result_out_of_range;
}

Eigen::Vector3f binary_vector(const char* row, const std::array<Coordinate, 3>& columns, std::endian order) {
  Eigen::Vector3f vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = load(row + columns[axis].byte, columns[axis].type, order);
  return finite_or_nan(vector);
}

// The words of a row of numbers.
class AsciiRow {
 public:
  AsciiRow(const PointTable& table, std::string_view line, int line_number) : table_(table), words_(split(line)), line_(line_number) {
    if (words_.size() == table.row_values) return;
    throw InputError(table.file, {line_number, 0},
                     "expected " + std::to_string(table.row_values) + " values, not " + std::to_string(words_.size()));
  }

  Eigen::Vector3f vector(const std::array<Coordinate, 3>& columns) const {
    Eigen::Vector3f vector;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words_[columns[axis].value];
      double value = 0.0;
      if (!parse(word, value)) throw InputError(table_.file, {line_, 0}, "'" + std::string(word) + "' is not a number");
      vector[axis] = static_cast<float>(value);
    }
    return finite_or_nan(vector);
  }

 private:
  const PointTable& table_;
  std::vector<std::string_view> words_;
  int line_;
};

std::vector<Eigen::Vector3f> column_vectors(const std::array<Coordinate, 3>& columns, std::size_t rows, std::string_view bytes) {
  std::vector<Eigen::Vector3f> vectors(rows);
  for (int axis = 0; axis < 3; ++axis) {
    const Coordinate& coordinate = columns[axis];
    const std::size_t size = coordinate.type == Coordinate::Type::float32 ? 4 : 8;
    const char* column = bytes.data() + rows * coordinate.byte;
    for (std::size_t i = 0; i < rows; ++i) vectors[i][axis] = load(column + i * size, coordinate.type, std::endian::little);
  }
  for (Eigen::Vector3f& vector : vectors) vector = finite_or_nan(vector);
  return vectors;
}

}  // namespace

PointCloud decode_binary(const PointTable& table, std::string_view bytes, std::endian order) {
  const std::size_t available = bytes.size() - std::min(bytes.size(), table.begin);
  if (available / table.row_bytes < table.rows) {
    throw InputError(table.file, "ends early: " + std::to_string(table.rows) + " points of " + std::to_string(table.row_bytes) +
                                     " bytes are declared, " + std::to_string(available) + " bytes are there");
  }
  PointCloud cloud;
  cloud.points.reserve(table.rows);
  const char* row = bytes.data() + table.begin;
  for (std::size_t i = 0; i < table.rows; ++i, row += table.row_bytes) {
    cloud.points.push_back(binary_vector(row, table.xyz, order));
    if (table.normal) cloud.normals.push_back(binary_vector(row, *table.normal, order));
  }
  return cloud;
}

PointCloud decode_ascii(const PointTable& table, std::string_view bytes, Remainder remainder) {
  std::size_t position = table.begin;
  int line_number = table.first_line - 1;
  PointCloud cloud;
  while (position < bytes.size() && (cloud.points.size() < table.rows || remainder == Remainder::none)) {
    const std::string_view line = take_line(bytes, position);
    ++line_number;
    if (line.find_first_not_of(kBlanks) == std::string_view::npos) continue;
    if (cloud.points.size() == table.rows) throw InputError(table.file, {line_number, 0}, "more points than declared");
    const AsciiRow row(table, line, line_number);
    cloud.points.push_back(row.vector(table.xyz));
    if (table.normal) cloud.normals.push_back(row.vector(*table.normal));
  }
  if (cloud.points.size() < table.rows) {
    throw InputError(table.file, "ends early: " + std::to_string(table.rows) + " points are declared, " +
                                     std::to_string(cloud.points.size()) + " are there");
  }
  return cloud;
}

PointCloud decode_columns(const PointTable& table, std::string_view bytes) {
  PointCloud cloud{.points = column_vectors(table.xyz, table.rows, bytes), .normals = {}};
  if (table.normal) cloud.normals = column_vectors(*table.normal, table.rows, bytes);
  return cloud;
}

bool CoordinateColumns::put(const std::string& name, const Coordinate& coordinate) {
  const auto index = static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  return !std::exchange(found_[index], coordinate).has_value();
}

bool CoordinateColumns::finish(PointTable& table) const {
  const auto three = [&](std::size_t first) -> std::optional<std::array<Coordinate, 3>> {
    if (!found_[first] || !found_[first + 1] || !found_[first + 2]) return std::nullopt;
    return std::array{*found_[first], *found_[first + 1], *found_[first + 2]};
  };
  const auto xyz = three(0);
  if (xyz) table.xyz = *xyz;
  table.normal = three(3);
  return xyz.has_value();
}

std::vector<std::string> HeaderLines::next() {
  constexpr std::size_t kLongestLine = std::size_t{1} << 16;
  ++line_;
  if (position_ >= bytes_.size()) fail("ends within the header");
  const std::string_view line = take_line(bytes_.substr(0, std::min(bytes_.size(), position_ + kLongestLine)), position_);
  if (line.size() == kLongestLine) fail("has no end of line in " + std::to_string(kLongestLine) + " bytes");
  const std::vector<std::string_view> words = split(line);
  return {words.begin(), words.end()};
}

void HeaderLines::fail(std::string_view message) const { throw InputError(file_, {line_, 0}, message); }

std::size_t HeaderLines::number(const std::string& word, std::size_t min, std::size_t max) const {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value < min || value > max) {
    fail("'" + word + "' must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return value;
}

}  // namespace alignability::detail
