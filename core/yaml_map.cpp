// SPDX-License-Identifier: BSD-3-Clause
#include "core/yaml_map.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/file.hpp"
#include "core/yaml_outline.hpp"

namespace alignability {
namespace {

TextPosition position_of(const YAML::Mark& mark) { return mark.is_null() ? TextPosition{} : TextPosition{mark.line + 1, mark.column + 1}; }

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }

}  // namespace

YamlMap YamlMap::from_file(const std::filesystem::path& file) { return from_text(read_file(file, kLargestFile), file); }

YamlMap YamlMap::from_text(const std::string& text, const std::filesystem::path& file) {
  try {
    detail::check_yaml_outline(text, file);
    return YamlMap(YAML::Load(text), file);
  } catch (const YAML::Exception& error) {
    throw InputError(file, position_of(error.mark), "not valid YAML: " + error.msg);
  }
}

YamlMap::YamlMap(YAML::Node node, std::filesystem::path file) : node_(std::move(node)), file_(std::move(file)) {
  if (!node_.IsMap()) fail_at(node_, "expected 'key: value' pairs");
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) fail_at(entry.first, "a key must be a word");
    if (!seen.insert(entry.first.Scalar()).second) fail_at(entry.first, "key " + in_quotes(entry.first.Scalar()) + " is given twice");
  }
}

std::optional<YAML::Node> YamlMap::find(std::string_view key) {
  asked_for_.emplace(key);
  for (const auto& entry : node_) {
    if (entry.first.Scalar() == key) return entry.second;
  }
  return std::nullopt;
}

std::optional<YAML::Node> YamlMap::find_scalar(std::string_view key, std::string_view kind) {
  std::optional<YAML::Node> node = find(key);
  if (node && !node->IsScalar()) fail_at(*node, in_quotes(key) + " must be " + std::string(kind));
  return node;
}

double YamlMap::to_number(const YAML::Node& node, std::string_view key, const Range& allowed) const {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) fail_at(node, in_quotes(key) + " must be a number");
  if (!allowed.contains(value)) {
    fail_at(node, in_quotes(key) + " must be " + allowed.description() + ", not " + node.Scalar());
  }
  return value;
}

std::optional<double> YamlMap::find_number(std::string_view key, const Range& allowed) {
  const auto node = find_scalar(key, "a number");
  return node ? std::optional(to_number(*node, key, allowed)) : std::nullopt;
}

std::optional<std::int64_t> YamlMap::find_integer(std::string_view key, std::int64_t min, std::int64_t max) {
  const auto node = find_scalar(key, "a whole number");
  if (!node) return std::nullopt;
  const std::string& text = node->Scalar();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < min || value > max) {
    fail_at(*node, in_quotes(key) + " must be a whole number from " + std::to_string(min) + " to " + std::to_string(max) + ", not " + text);
  }
  return value;
}

std::optional<std::string> YamlMap::find_text(std::string_view key) {
  const auto node = find_scalar(key, "a word");
  return node ? std::optional(node->Scalar()) : std::nullopt;
}

std::optional<std::filesystem::path> YamlMap::find_path(std::string_view key) {
  const auto text = find_text(key);
  if (!text) return std::nullopt;
  if (text->empty()) fail(key, in_quotes(key) + " must name a file");
  return file_.parent_path() / *text;
}

std::optional<std::vector<double>> YamlMap::find_numbers(std::string_view key, const Range& allowed) {
  const auto node = find(key);
  if (!node) return std::nullopt;
  if (!node->IsSequence()) fail_at(*node, in_quotes(key) + " must be a list of numbers");
  std::vector<double> values;
  for (const YAML::Node& item : *node) values.push_back(to_number(item, key, allowed));
  return values;
}

std::optional<std::vector<double>> YamlMap::find_numbers(std::string_view key, std::size_t count, const Range& allowed) {
  auto values = find_numbers(key, allowed);
  if (values && values->size() != count) {
    fail(key, in_quotes(key) + " must be a list of " + std::to_string(count) + " numbers, not " + std::to_string(values->size()));
  }
  return values;
}

std::optional<std::vector<Eigen::Vector2d>> YamlMap::find_points(std::string_view key, const Range& allowed) {
  const auto node = find(key);
  if (!node) return std::nullopt;
  const std::string message = in_quotes(key) + " must be a list of points [x, y]";
  if (!node->IsSequence()) fail_at(*node, message);
  std::vector<Eigen::Vector2d> points;
  for (const YAML::Node& item : *node) {
    if (!item.IsSequence() || item.size() != 2) fail_at(item, message);
    points.emplace_back(to_number(item[0], key, allowed), to_number(item[1], key, allowed));
  }
  return points;
}

std::optional<std::vector<std::string>> YamlMap::find_texts(std::string_view key) {
  const auto node = find(key);
  if (!node) return std::nullopt;
  if (!node->IsSequence()) fail_at(*node, in_quotes(key) + " must be a list of words");
  std::vector<std::string> values;
  for (const YAML::Node& item : *node) {
    if (!item.IsScalar()) fail_at(item, in_quotes(key) + " must be a list of words");
    values.push_back(item.Scalar());
  }
  return values;
}

std::optional<YamlMap> YamlMap::find_map(std::string_view key) {
  const auto node = find(key);
  if (!node) return std::nullopt;
  if (!node->IsMap()) fail_at(*node, in_quotes(key) + " must hold 'key: value' pairs");
  return YamlMap(*node, file_);
}

std::optional<std::vector<YamlMap>> YamlMap::find_maps(std::string_view key) {
  const auto node = find(key);
  if (!node) return std::nullopt;
  const std::string message = in_quotes(key) + " must be a list of 'key: value' pairs";
  if (!node->IsSequence()) fail_at(*node, message);
  std::vector<YamlMap> maps;
  for (const YAML::Node& item : *node) {
    if (!item.IsMap()) fail_at(item, message);
    maps.push_back(YamlMap(item, file_));
  }
  return maps;
}

double YamlMap::number(std::string_view key, const Range& allowed) {
  const auto value = find_number(key, allowed);
  return value ? *value : (fail_missing(key), 0.0);
}

std::int64_t YamlMap::integer(std::string_view key, std::int64_t min, std::int64_t max) {
  const auto value = find_integer(key, min, max);
  return value ? *value : (fail_missing(key), 0);
}

std::string YamlMap::text(std::string_view key) {
  auto value = find_text(key);
  if (!value) fail_missing(key);
  return *std::move(value);
}

std::filesystem::path YamlMap::path(std::string_view key) {
  auto value = find_path(key);
  if (!value) fail_missing(key);
  return *std::move(value);
}

std::vector<double> YamlMap::numbers(std::string_view key, std::size_t count, const Range& allowed) {
  auto values = find_numbers(key, count, allowed);
  if (!values) fail_missing(key);
  return *std::move(values);
}

std::vector<std::string> YamlMap::texts(std::string_view key) {
  auto values = find_texts(key);
  if (!values) fail_missing(key);
  return *std::move(values);
}

YamlMap YamlMap::map(std::string_view key) {
  auto value = find_map(key);
  if (!value) fail_missing(key);
  return *std::move(value);
}

bool YamlMap::has(std::string_view key) const {
  return std::ranges::any_of(node_, [&](const auto& entry) { return entry.first.Scalar() == key; });
}

bool YamlMap::is_sequence(std::string_view key) const {
  return std::ranges::any_of(node_, [&](const auto& entry) { return entry.first.Scalar() == key && entry.second.IsSequence(); });
}

void YamlMap::finish() const {
  const std::vector<std::string> known(asked_for_.begin(), asked_for_.end());
  for (const auto& entry : node_) {
    const std::string& key = entry.first.Scalar();
    if (!asked_for_.contains(key)) fail_at(entry.first, "unknown key " + in_quotes(key) + did_you_mean(key, known));
  }
}

YAML::Node YamlMap::value_or_mapping(std::string_view key) const {
  for (const auto& entry : node_) {
    if (entry.first.Scalar() == key) return entry.second;
  }
  return node_;
}

void YamlMap::fail(std::string_view key, std::string_view message) const { fail_at(value_or_mapping(key), message); }

TextPosition YamlMap::position(std::string_view key) const { return position_of(value_or_mapping(key).Mark()); }

std::vector<std::string> YamlMap::keys() const {
  std::vector<std::string> keys;
  for (const auto& entry : node_) keys.push_back(entry.first.Scalar());
  return keys;
}

// The likeliest cause of a missing key is a misspelt one, so those are looked for first.
void YamlMap::fail_missing(std::string_view key) const {
  const std::vector<std::string> missing(asked_for_.begin(), asked_for_.end());
  for (const auto& entry : node_) {
    const std::string& given = entry.first.Scalar();
    if (asked_for_.contains(given)) continue;
    const std::string hint = did_you_mean(given, missing);
    if (!hint.empty()) fail_at(entry.first, "unknown key " + in_quotes(given) + hint);
  }
  fail_at(node_, "missing key " + in_quotes(key));
}

void YamlMap::fail_at(const YAML::Node& node, std::string_view message) const {
  throw InputError(file_, position_of(node.Mark()), message);
}

std::size_t YamlMap::choice_index(std::string_view key, const std::string& name, const std::vector<std::string>& names) const {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string list;
  for (const std::string& choice : names) list += (list.empty() ? "" : ", ") + choice;
  fail(key, in_quotes(key) + " is " + in_quotes(name) + ", which is none of: " + list + did_you_mean(name, names));
}

}  // namespace alignability
