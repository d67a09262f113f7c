// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/ply_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/input_error.hpp"
#include "lidar/point_table.hpp"

namespace alignability::detail {
namespace {

enum class Format { ascii, little_endian, big_endian };

std::size_t size_of(const std::string& type, const HeaderLines& lines) {
  static const std::map<std::string, std::size_t> kSizes{
      {"char", 1}, {"uchar", 1}, {"short", 2}, {"ushort", 2}, {"int", 4},   {"uint", 4},   {"float", 4},   {"double", 8},
      {"int8", 1}, {"uint8", 1}, {"int16", 2}, {"uint16", 2}, {"int32", 4}, {"uint32", 4}, {"float32", 4}, {"float64", 8}};
  const auto found = kSizes.find(type);
  if (found != kSizes.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, size] : kSizes) names.push_back(name);
  lines.fail("'" + type + "' is no type of a PLY file" + did_you_mean(type, names));
}

const std::array<std::string, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::filesystem::path& file, std::size_t most_rows)
      : lines_(file, bytes), most_rows_(most_rows) {
    table_.file = file;
  }

  std::pair<PointTable, Format> read() {
    if (lines_.next() != std::vector<std::string>{"ply"}) lines_.fail("a PLY file begins with a line 'ply'");
    for (std::vector<std::string> words = lines_.next(); words.empty() || words[0] != "end_header"; words = lines_.next()) read_line(words);
    if (!format_) lines_.fail("the header has no 'format'");
    if (!columns_.finish(table_)) lines_.fail("the header has no element 'vertex' with properties x, y and z");
    if (table_.rows == 0) lines_.fail("holds no points");
    table_.begin = lines_.position();
    table_.first_line = lines_.line() + 1;
    return {table_, *format_};
  }

  bool declares_faces() const { return faces_; }

 private:
  enum class Element { none, vertex, later };

  void read_line(const std::vector<std::string>& words) {
    static const std::vector<std::string> kKeywords{"comment", "element", "end_header", "format", "obj_info", "property"};
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
    if (words[0] == "format" && words.size() == 3) return read_format(words[1]);
    if (words[0] == "element" && words.size() == 3) return read_element(words[1], words[2]);
    if (words[0] == "property" && words.size() >= 3) return read_property(words);
    const bool known = std::ranges::find(kKeywords, words[0]) != kKeywords.end();
    lines_.fail("'" + words[0] + (known ? "' is no complete line" : "' is no keyword") + " of a PLY header" +
                (known ? "" : did_you_mean(words[0], kKeywords)));
  }

  void read_format(const std::string& name) {
    if (format_) lines_.fail("'format' is given twice");
    if (name == "ascii") format_ = Format::ascii;
    if (name == "binary_little_endian") format_ = Format::little_endian;
    if (name == "binary_big_endian") format_ = Format::big_endian;
    static const std::vector<std::string> kFormats{"ascii", "binary_big_endian", "binary_little_endian"};
    if (!format_) lines_.fail("'" + name + "' is no format of a PLY file" + did_you_mean(name, kFormats));
  }

  void read_element(const std::string& name, const std::string& count) {
    const std::size_t rows = lines_.number(count, 0, most_rows_);
    if (name == "vertex") {
      if (element_ != Element::none) lines_.fail("'vertex' must be the first element, and the only one of its name");
      element_ = Element::vertex;
      table_.rows = rows;
    } else {
      if (element_ == Element::none) lines_.fail("'vertex' must be the first element");
      element_ = Element::later;
      faces_ = faces_ || (rows > 0 && (name == "face" || name == "tristrips"));
    }
  }

  void read_property(const std::vector<std::string>& words) {
    if (element_ == Element::none) lines_.fail("a property before any element");
    if (element_ == Element::later) return;
    if (words.size() != 3) lines_.fail("a vertex with a list is not supported");
    const std::size_t size = size_of(words[1], lines_);
    if (columns_.has(words[2])) {
      const bool real = words[1].starts_with("float") || words[1] == "double";
      if (!real) lines_.fail("'" + words[2] + "' must be a float or a double");
      const auto type = size == 4 ? Coordinate::Type::float32 : Coordinate::Type::float64;
      const bool first = columns_.put(words[2], {.type = type, .byte = table_.row_bytes, .value = table_.row_values});
      if (!first) lines_.fail("'" + words[2] + "' is given twice");
    }
    table_.row_bytes += size;
    table_.row_values += 1;
    if (table_.row_bytes > kMostRowBytes) lines_.fail("a vertex has more than " + std::to_string(kMostRowBytes) + " bytes");
  }

  HeaderLines lines_;
  std::size_t most_rows_;
  PointTable table_;
  std::optional<Format> format_;
  Element element_ = Element::none;
  CoordinateColumns columns_{kNames};
  bool faces_ = false;
};

PointCloud decode(const PointTable& table, Format format, std::string_view bytes) {
  if (format == Format::ascii) return decode_ascii(table, bytes, Remainder::anything);
  return decode_binary(table, bytes, format == Format::little_endian ? std::endian::little : std::endian::big);
}

}  // namespace

PointCloud parse_ply(std::string_view bytes, const std::filesystem::path& file) {
  const auto [table, format] = HeaderReader(bytes, file, kMostPoints).read();
  return decode(table, format, bytes);
}

bool declares_faces(std::string_view bytes, const std::filesystem::path& file) {
  HeaderReader header(bytes, file, kMostPoints);
  header.read();
  return header.declares_faces();
}

void check_ply_header(std::string_view bytes, const std::filesystem::path& file) { HeaderReader(bytes, file, bytes.size()).read(); }

}  // namespace alignability::detail
