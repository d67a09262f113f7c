// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/pcd_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/input_error.hpp"
#include "lidar/point_table.hpp"

namespace alignability::detail {
namespace {

enum class Encoding { ascii, binary, compressed };

// COUNT values of one type: a column of the file.
struct Field {
  std::string name;
  std::size_t size = 0;
  char type = 'F';
  std::size_t count = 1;

  std::size_t bytes() const { return size * count; }
};

struct Header {
  std::vector<Field> fields;
  std::size_t width = 0;
  std::size_t height = 0;
  Encoding encoding = Encoding::ascii;
  std::size_t begin = 0;
  int lines = 0;
};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::filesystem::path& file) : lines_(file, bytes) {}

  Header read() {
    std::vector<std::string> words;
    do {
      words = lines_.next();
      if (words.empty() || words[0].starts_with('#')) continue;
      if (!seen_.try_emplace(words[0], lines_.line()).second) lines_.fail("'" + words[0] + "' is given twice");
      read_entry(words[0], {words.begin() + 1, words.end()});
    } while (words.empty() || words[0] != "DATA");
    for (const char* key : {"FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT", "POINTS"}) {
      if (!seen_.contains(key)) lines_.fail("the header has no '" + std::string(key) + "'");
    }
    if (points_ != header_.width * header_.height) lines_.fail("POINTS is not WIDTH times HEIGHT");
    if (points_ == 0) lines_.fail("holds no points");
    header_.begin = lines_.position();
    header_.lines = lines_.line();
    return header_;
  }

 private:
  void read_entry(const std::string& key, const std::vector<std::string>& values) {
    constexpr std::size_t kMostFields = 1024;
    if (key == "VERSION" || key == "VIEWPOINT") return;
    if (key == "FIELDS") {
      if (values.empty() || values.size() > kMostFields)
        lines_.fail("'FIELDS' must name from 1 to " + std::to_string(kMostFields) + " fields");
      for (const std::string& name : values) header_.fields.push_back({.name = name});
      return;
    }
    const bool one_a_field = key == "SIZE" || key == "TYPE" || key == "COUNT";
    if (one_a_field && header_.fields.empty()) lines_.fail("'" + key + "' stands before 'FIELDS'");
    const std::size_t expected = one_a_field ? header_.fields.size() : 1;
    if (values.size() != expected) {
      lines_.fail("'" + key + "' must have " + std::to_string(expected) + " values" + (one_a_field ? ", as 'FIELDS' before it" : ""));
    }
    for (std::size_t i = 0; i < values.size(); ++i) read_value(key, values[i], i);
  }

  void read_value(const std::string& key, const std::string& value, std::size_t index) {
    if (key == "SIZE") {
      header_.fields[index].size = lines_.number(value, 1, 8);
    } else if (key == "TYPE") {
      if (value != "I" && value != "U" && value != "F") lines_.fail("a type is I, U or F, not '" + value + "'");
      header_.fields[index].type = value[0];
    } else if (key == "COUNT") {
      header_.fields[index].count = lines_.number(value, 1, kMostRowBytes);
    } else if (key == "WIDTH") {
      header_.width = lines_.number(value, 0, kMostPoints);
    } else if (key == "HEIGHT") {
      header_.height = lines_.number(value, 0, kMostPoints);
    } else if (key == "POINTS") {
      points_ = lines_.number(value, 0, kMostPoints);
    } else if (key == "DATA") {
      read_encoding(value);
    } else {
      static const std::vector<std::string> kKeys{"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                  "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
      lines_.fail("'" + key + "' is no entry of a PCD header" + did_you_mean(key, kKeys));
    }
  }

  void read_encoding(const std::string& value) {
    if (value == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (value == "binary") {
      header_.encoding = Encoding::binary;
    } else if (value == "binary_compressed") {
      header_.encoding = Encoding::compressed;
    } else {
      static const std::vector<std::string> kEncodings{"ascii", "binary", "binary_compressed"};
      lines_.fail("'DATA' is ascii, binary or binary_compressed, not '" + value + "'" + did_you_mean(value, kEncodings));
    }
  }

  HeaderLines lines_;
  Header header_;
  std::map<std::string, int> seen_;
  std::size_t points_ = 0;
};

PointTable table_of(const Header& header, const std::filesystem::path& file) {
  PointTable table;
  table.file = file;
  table.rows = header.width * header.height;
  table.begin = header.begin;
  table.first_line = header.lines + 1;
  static const std::array<std::string, 6> kNames{"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  CoordinateColumns columns(kNames);
  for (const Field& field : header.fields) {
    // PCL writes its padding, named "_", into binary files and leaves it out of compressed ones.
    if (field.name == "_" && header.encoding == Encoding::compressed) continue;
    if (columns.has(field.name)) {
      if (field.type != 'F' || (field.size != 4 && field.size != 8) || field.count != 1) {
        throw InputError(file, "field '" + field.name + "' must be one F of size 4 or 8");
      }
      const auto type = field.size == 4 ? Coordinate::Type::float32 : Coordinate::Type::float64;
      const bool first = columns.put(field.name, {.type = type, .byte = table.row_bytes, .value = table.row_values});
      if (!first) throw InputError(file, "field '" + field.name + "' is given twice");
    }
    table.row_bytes += field.bytes();
    table.row_values += field.count;
    if (table.row_bytes > kMostRowBytes) throw InputError(file, "a point has more than " + std::to_string(kMostRowBytes) + " bytes");
  }
  if (!columns.finish(table)) throw InputError(file, "has no fields x, y and z");
  return table;
}

// LZF by Marc Lehmann, as PCL uses it: a byte below 32 heads a run of literal bytes; others hold a length and, with the bytes that follow,
// how far back to copy from. Nothing when the input does not unpack to exactly `size` bytes.
std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t size) {
  std::string out;
  out.reserve(size);
  std::size_t in = 0;
  const auto next = [&] { return static_cast<unsigned char>(packed[in++]); };
  while (in < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > packed.size() - in || length > size - out.size()) return std::nullopt;
      out.append(packed.substr(in, length));
      in += length;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    if (packed.size() - in < (length == 9 ? 2u : 1u)) return std::nullopt;
    if (length == 9) length += next();
    const std::size_t distance = ((control & 31) << 8) + next() + 1;
    if (distance > out.size() || length > size - out.size()) return std::nullopt;
    for (std::size_t i = 0; i < length; ++i) out.push_back(out[out.size() - distance]);
  }
  return out.size() == size ? std::optional(std::move(out)) : std::nullopt;
}

std::uint32_t load_size(std::string_view bytes, std::size_t position) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[position + i]);
  return value;
}

std::string unpacked(const PointTable& table, std::string_view bytes) {
  // Three bytes stand for at most 264.
  constexpr std::size_t kHighestRatio = 88;
  constexpr std::size_t kSizes = 2 * sizeof(std::uint32_t);
  const std::string_view data = bytes.substr(table.begin);
  if (data.size() < kSizes) throw InputError(table.file, "ends before the compressed points");
  const std::size_t packed_size = load_size(data, 0);
  const std::size_t size = load_size(data, sizeof(std::uint32_t));
  if (packed_size > data.size() - kSizes)
    throw InputError(table.file, "ends early: " + std::to_string(packed_size) + " bytes of compressed points are declared");
  if (size != table.rows * table.row_bytes || size / kHighestRatio > packed_size) {
    throw InputError(table.file, "the size of its compressed points does not fit the header");
  }
  std::optional<std::string> result = unpack_lzf(data.substr(kSizes, packed_size), size);
  if (!result) throw InputError(table.file, "the compressed points cannot be unpacked");
  return *std::move(result);
}

PointCloud decode(const PointTable& table, Encoding encoding, std::string_view bytes) {
  if (encoding == Encoding::ascii) return decode_ascii(table, bytes, Remainder::none);
  if (encoding == Encoding::binary) return decode_binary(table, bytes, std::endian::little);
  return decode_columns(table, unpacked(table, bytes));
}

}  // namespace

OrderedCloud parse_pcd(std::string_view bytes, const std::filesystem::path& file) {
  const Header header = HeaderReader(bytes, file).read();
  return {.cloud = decode(table_of(header, file), header.encoding, bytes),
          .rings = static_cast<int>(header.height),
          .columns = static_cast<int>(header.width)};
}

}  // namespace alignability::detail
