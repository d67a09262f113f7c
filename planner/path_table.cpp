// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "core/input_error.hpp"
#include "planner/headings.hpp"
#include "planner/route_formats.hpp"

namespace alignability::detail {
namespace {

constexpr std::string_view kBlanks = " \t";

struct Field {
  std::string_view text;  // without blanks and quotes around it
  int column = 1;
};

struct Line {
  std::string_view text;
  int number = 0;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string_view unquoted(std::string_view text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

// The lines that say something.
std::vector<Line> lines_of(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Line> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view said = trimmed(line);
    if (!said.empty() && !said.starts_with('#')) lines.push_back({line, number});
  }
  return lines;
}

// ';' where there is one, since commas may then be decimal ones and are refused as such; ' ' stands for any run of blanks.
char separator_of(std::string_view line) {
  for (const char separator : {';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

std::vector<Field> fields_of(std::string_view line, char separator) {
  std::vector<Field> fields;
  const auto add = [&](std::size_t begin, std::size_t end) {
    const std::size_t text = std::min(line.find_first_not_of(kBlanks, begin), end);
    fields.push_back({unquoted(trimmed(line.substr(begin, end - begin))), static_cast<int>(text) + 1});
  };
  std::size_t begin = 0;
  while (true) {
    if (separator == ' ') begin = std::min(line.find_first_not_of(kBlanks, begin), line.size());
    if (separator == ' ' && begin == line.size()) return fields;
    const std::size_t end = std::min(separator == ' ' ? line.find_first_of(kBlanks, begin) : line.find(separator, begin), line.size());
    add(begin, end);
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

// Which columns hold what.
struct Columns {
  std::size_t count = 0;
  std::size_t x = 0;
  std::size_t y = 1;
  std::optional<std::size_t> yaw;
};

class PathTable {
 public:
  PathTable(std::string_view text, const std::filesystem::path& file) : lines_(lines_of(text)), file_(file) {
    if (lines_.empty()) throw InputError(file_, "holds no places: a path has a line with x, y and, where it has one, yaw for each");
    separator_ = separator_of(lines_.front().text);
    const std::vector<Field> first = fields_of(lines_.front().text, separator_);
    const bool is_header = !number_in(first.front().text);
    columns_ = is_header ? named_columns(first) : unnamed_columns(first);
    if (is_header) lines_.erase(lines_.begin());
  }

  Route read() const {
    Route route;
    for (const Line& line : lines_) route.path.push_back(pose(line));
    if (route.path.empty()) throw InputError(file_, "names its columns, but holds no places");
    if (!columns_.yaw) {
      if (std::ranges::all_of(route.path, [&](const Pose2& pose) { return pose == route.path.front(); })) {
        throw InputError(file_, "stays in one place, and has no yaw there");
      }
      route.path = turning_on_the_spot(looking_ahead(std::move(route.path), 0.0));
      route.remarks.push_back("there is no yaw: the robot looks where it goes");
    } else if (std::ranges::any_of(route.path, [](const Pose2& pose) { return std::abs(pose.yaw) > 2.0 * std::numbers::pi; })) {
      route.remarks.push_back("yaw is read in radians, and exceeds a full turn");
    }
    return route;
  }

 private:
  Columns named_columns(const std::vector<Field>& header) const {
    std::vector<std::string> names;
    for (const Field& field : header) names.emplace_back(field.text);
    const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
      const auto found = std::ranges::find(names, name);
      if (found == names.end()) return std::nullopt;
      const auto again = std::find(found + 1, names.end(), name);
      if (again != names.end())
        fail(lines_.front(), header[static_cast<std::size_t>(again - names.begin())], "there is another column '" + name + '\'');
      return static_cast<std::size_t>(found - names.begin());
    };
    const auto need = [&](const std::string& name) {
      if (const auto found = find(name)) return *found;
      fail(lines_.front(), header.front(),
           "there is no column '" + name + "' among the names: a path needs x, y and, where it has one, yaw");
    };
    return {.count = names.size(), .x = need("x"), .y = need("y"), .yaw = find("yaw")};
  }

  Columns unnamed_columns(const std::vector<Field>& first) const {
    if (first.size() != 2 && first.size() != 3) {
      fail(lines_.front(), first.front(),
           std::to_string(first.size()) + " columns need a line before them that names x, y and, where there is one, yaw");
    }
    return {.count = first.size(), .yaw = first.size() == 3 ? std::optional<std::size_t>(2) : std::nullopt};
  }

  Pose2 pose(const Line& line) const {
    const std::vector<Field> fields = fields_of(line.text, separator_);
    if (fields.size() != columns_.count) {
      fail(line, fields.front(),
           "there must be " + std::to_string(columns_.count) + " values, as on the first line, not " + std::to_string(fields.size()));
    }
    const auto number = [&](const char* name, std::size_t column, const Range& allowed) {
      const auto value = number_in(fields[column].text);
      if (value && allowed.contains(*value)) return *value;
      const std::string type = value ? allowed.description() : "a number";
      fail(line, fields[column], '\'' + std::string(name) + "' must be " + type + ", not '" + std::string(fields[column].text) + '\'');
    };
    return {number("x", columns_.x, kPlaces), number("y", columns_.y, kPlaces), columns_.yaw ? number("yaw", *columns_.yaw, kFinite) : 0.0};
  }

  [[noreturn]] void fail(const Line& line, const Field& field, std::string_view message) const {
    throw InputError(file_, {line.number, field.column}, message);
  }

  std::vector<Line> lines_;
  const std::filesystem::path& file_;
  char separator_ = ',';
  Columns columns_;
};

}  // namespace

Route parse_path_table(std::string_view text, const std::filesystem::path& file) { return PathTable(text, file).read(); }

}  // namespace alignability::detail
