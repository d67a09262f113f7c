// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/range.hpp"

namespace alignability::detail {

/// A value in a JSON file. Every fault is an InputError at the line and column where the value begins. Cheap to copy.
class JsonValue {
 public:
  /// Reads a file of at most `kLargestFile` bytes, nested no deeper than 64 levels, in which no object has a key twice.
  static JsonValue from_file(const std::filesystem::path& file);
  static constexpr std::uintmax_t kLargestFile = 32u << 20;

  /// nullopt when an object has no such key, or null for it.
  std::optional<JsonValue> find(std::string_view key) const;
  /// Refuses absence.
  JsonValue at(std::string_view key) const;
  std::vector<JsonValue> items() const;
  double number(const Range& allowed) const;
  /// Written as such, or with no fraction: 3 and 3.0.
  std::int64_t integer(std::int64_t min, std::int64_t max) const;
  std::string text() const;

  [[noreturn]] void fail(std::string_view message) const;

 private:
  struct Document;

  JsonValue(std::shared_ptr<const Document> document, const nlohmann::json& value, std::string pointer);
  [[noreturn]] void fail_type(std::string_view type) const;
  std::string name() const;

  std::shared_ptr<const Document> document_;
  const nlohmann::json* value_;
  std::string pointer_;  // /features/3/properties, its tokens as they stand in the file
};

}  // namespace alignability::detail
