// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input_error.hpp"
#include "core/range.hpp"

namespace alignability {

/// A YAML mapping read strictly: every key is asked for by name and type, and `finish()` refuses those nobody asked for.
/// Every fault is an InputError at the line and column of the key or value that has it. `find_…` gives nullopt when the key is
/// absent; the form without `find_` refuses absence. A key given twice is refused when the mapping is opened.
class YamlMap {
 public:
  /// Reads a file of at most `kLargestFile` bytes whose root is a mapping.
  static YamlMap from_file(const std::filesystem::path& file);
  /// The same for a text; `file` is the name that errors show and that relative paths resolve against.
  static YamlMap from_text(const std::string& text, const std::filesystem::path& file);

  static constexpr std::uintmax_t kLargestFile = 16u << 20;

  const std::filesystem::path& file() const { return file_; }

  std::optional<double> find_number(std::string_view key, const Range& allowed);
  double number(std::string_view key, const Range& allowed);
  /// Integers from `min` to `max`, written as such: 3, never 3.0.
  std::optional<std::int64_t> find_integer(std::string_view key, std::int64_t min, std::int64_t max);
  std::int64_t integer(std::string_view key, std::int64_t min, std::int64_t max);
  std::optional<std::string> find_text(std::string_view key);
  std::string text(std::string_view key);
  /// A path as written, resolved against the folder of this file.
  std::optional<std::filesystem::path> find_path(std::string_view key);
  std::filesystem::path path(std::string_view key);
  std::optional<std::vector<double>> find_numbers(std::string_view key, const Range& allowed);
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count, const Range& allowed);
  std::optional<std::vector<double>> find_numbers(std::string_view key, std::size_t count, const Range& allowed);
  /// [[x, y], …].
  std::optional<std::vector<Eigen::Vector2d>> find_points(std::string_view key, const Range& allowed);
  std::optional<std::vector<std::string>> find_texts(std::string_view key);
  std::vector<std::string> texts(std::string_view key);
  std::optional<YamlMap> find_map(std::string_view key);
  YamlMap map(std::string_view key);
  /// A list of mappings.
  std::optional<std::vector<YamlMap>> find_maps(std::string_view key);
  /// The value whose name the key gives; a name that is none of `choices` is refused and the choices are listed.
  template <typename T, std::size_t N>
  std::optional<T> find_choice(std::string_view key, const std::pair<const char*, T> (&choices)[N]);

  bool has(std::string_view key) const;
  /// Of the value of a key, or of the mapping where the key is absent.
  TextPosition position(std::string_view key) const;
  /// In the order of the file.
  std::vector<std::string> keys() const;
  bool is_sequence(std::string_view key) const;

  /// Refuses keys that nobody asked for. Call it once the last key has been asked for.
  void finish() const;
  /// Throws an InputError at the value of `key`, or at the mapping where the key is absent.
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;

 private:
  YamlMap(YAML::Node node, std::filesystem::path file);

  std::optional<YAML::Node> find(std::string_view key);
  std::optional<YAML::Node> find_scalar(std::string_view key, std::string_view kind);
  YAML::Node value_or_mapping(std::string_view key) const;
  [[noreturn]] void fail_missing(std::string_view key) const;
  [[noreturn]] void fail_at(const YAML::Node& node, std::string_view message) const;
  double to_number(const YAML::Node& node, std::string_view key, const Range& allowed) const;
  std::size_t choice_index(std::string_view key, const std::string& name, const std::vector<std::string>& names) const;

  YAML::Node node_;
  std::filesystem::path file_;
  std::set<std::string, std::less<>> asked_for_;
};

template <typename T, std::size_t N>
std::optional<T> YamlMap::find_choice(std::string_view key, const std::pair<const char*, T> (&choices)[N]) {
  const std::optional<std::string> name = find_text(key);
  if (!name) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& choice : choices) names.emplace_back(choice.first);
  return choices[choice_index(key, *name, names)].second;
}

}  // namespace alignability
