// SPDX-License-Identifier: BSD-3-Clause
#include "planner/json_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/file.hpp"
#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

using Json = nlohmann::json;

TextPosition position_at(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = std::ranges::count(before, '\n');
  return {static_cast<int>(line) + 1, static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1};
}

// Reads a text for the parser, and tells how far it has got.
struct Reader {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** farthest = nullptr;

  reference operator*() const { return *at; }
  Reader& operator++() {
    *farthest = ++at;
    return *this;
  }
  Reader operator++(int) {
    Reader before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Reader& other) const { return at == other.at; }
};

// Follows the parser through a text, of which it gives no places itself; refuses what the parser does not. Looks for the value of a
// pointer, if it is given one.
class Follower : public nlohmann::json_sax<Json> {
 public:
  Follower(std::string_view text, const std::filesystem::path& file, const std::string* wanted)
      : text_(text), file_(file), wanted_(wanted), farthest_(text.data()) {
    Json::sax_parse(Reader{text.data(), &farthest_}, Reader{text.data() + text.size(), &farthest_}, this);
  }

  /// The byte where the wanted value begins.
  std::optional<std::size_t> found() const { return found_; }

  bool null() override { return begin_value(); }
  bool boolean(bool) override { return begin_value(); }
  bool number_integer(number_integer_t) override { return begin_value(); }
  bool number_unsigned(number_unsigned_t) override { return begin_value(); }
  bool number_float(number_float_t, const string_t&) override { return begin_value(); }
  bool string(string_t&) override { return begin_value(); }
  bool binary(binary_t&) override { return begin_value(); }
  bool start_object(std::size_t) override { return begin_value() && begin_level(true); }
  bool start_array(std::size_t) override { return begin_value() && begin_level(false); }
  bool end_object() override { return end_level(); }
  bool end_array() override { return end_level(); }

  bool key(string_t& name) override {
    if (!levels_.back().keys.insert(name).second) fail(begin_of_next(), "key '" + name + "' is given twice");
    levels_.back().key = name;
    return go_on();
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    const std::string what = error.what();
    const bool is_syntax = dynamic_cast<const Json::parse_error*>(&error) != nullptr;
    // Of what the library says, the part after the number of the error and its place.
    const std::size_t head = is_syntax ? what.find(": ") : what.find("] ");
    const std::size_t byte = is_syntax ? std::max<std::size_t>(position, 1) - 1 : begin_of_next();
    fail(byte, "is not JSON: " + what.substr(head == std::string::npos ? 0 : head + 2));
  }

 private:
  struct Level {
    std::string pointer;  // kept up only where one is wanted
    std::string key;      // of the next value; an object's
    std::set<std::string> keys;
    std::size_t index = 0;  // of the next item; a list's
    bool is_object = false;
  };

  bool begin_value() {
    if (wanted_ != nullptr) {
      if (levels_.empty()) {
        pointer_.clear();
      } else {
        Level& level = levels_.back();
        pointer_ = level.pointer + '/' + (level.is_object ? level.key : std::to_string(level.index++));
      }
      if (!found_ && pointer_ == *wanted_) found_ = begin_of_next();
    }
    return go_on();
  }

  bool begin_level(bool is_object) {
    constexpr std::size_t kDeepest = 64;
    if (levels_.size() == kDeepest) fail(last_ - 1, "is nested deeper than " + std::to_string(kDeepest) + " levels");
    levels_.emplace_back();
    levels_.back().pointer = pointer_;
    levels_.back().is_object = is_object;
    return true;
  }

  bool end_level() {
    levels_.pop_back();
    return go_on();
  }

  bool go_on() {
    last_ = static_cast<std::size_t>(farthest_ - text_.data());
    return true;
  }

  // The parser has read what it told of last, and perhaps the one character after it that ends a number.
  std::size_t begin_of_next() const { return text_.find_first_not_of(" \t\r\n,:", last_); }

  [[noreturn]] void fail(std::size_t byte, std::string_view message) const { throw InputError(file_, position_at(text_, byte), message); }

  std::string_view text_;
  const std::filesystem::path& file_;
  const std::string* wanted_;
  const char* farthest_;
  std::size_t last_ = 0;
  std::vector<Level> levels_;
  std::string pointer_;
  std::optional<std::size_t> found_;
};

}  // namespace

struct JsonValue::Document {
  std::filesystem::path file;
  std::string text;
  Json root;
};

JsonValue JsonValue::from_file(const std::filesystem::path& file) {
  auto document = std::make_shared<Document>();
  document->file = file;
  document->text = read_file(file, kLargestFile);
  Follower(document->text, file, nullptr);
  document->root = Json::parse(document->text);
  const Json& root = document->root;
  return JsonValue(std::move(document), root, "");
}

JsonValue::JsonValue(std::shared_ptr<const Document> document, const Json& value, std::string pointer)
    : document_(std::move(document)), value_(&value), pointer_(std::move(pointer)) {}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  if (!value_->is_object()) fail_type("an object");
  const std::string name(key);
  const auto found = value_->find(name);
  if (found == value_->end() || found->is_null()) return std::nullopt;
  return JsonValue(document_, *found, pointer_ + '/' + name);
}

JsonValue JsonValue::at(std::string_view key) const {
  if (const auto value = find(key)) return *value;
  fail("missing key '" + std::string(key) + '\'');
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_->is_array()) fail_type("a list");
  std::vector<JsonValue> values;
  for (const Json& item : *value_) values.push_back(JsonValue(document_, item, pointer_ + '/' + std::to_string(values.size())));
  return values;
}

double JsonValue::number(const Range& allowed) const {
  if (!value_->is_number()) fail_type("a number");
  const auto number = value_->get<double>();
  if (!allowed.contains(number)) fail_type(allowed.description());
  return number;
}

std::int64_t JsonValue::integer(std::int64_t min, std::int64_t max) const {
  const Range allowed{.min = static_cast<double>(min), .max = static_cast<double>(max)};
  const double number = value_->is_number() ? value_->get<double>() : 0.5;
  if (number != std::floor(number) || !allowed.contains(number)) fail_type("a whole number " + allowed.description());
  return value_->get<std::int64_t>();
}

std::string JsonValue::text() const {
  if (!value_->is_string()) fail_type("a text");
  return value_->get<std::string>();
}

void JsonValue::fail(std::string_view message) const {
  const Follower follower(document_->text, document_->file, &pointer_);
  const TextPosition position = follower.found() ? position_at(document_->text, *follower.found()) : TextPosition{};
  throw InputError(document_->file, position, message);
}

void JsonValue::fail_type(std::string_view type) const {
  constexpr std::size_t kLongest = 40;
  std::string found = value_->is_structured() ? value_->type_name() : value_->dump(-1, ' ', true);
  if (found.size() > kLongest) found = value_->type_name();
  fail(name() + " must be " + std::string(type) + ", not " + found);
}

std::string JsonValue::name() const {
  std::string_view rest = pointer_;
  bool is_item = false;
  while (!rest.empty()) {
    const std::string_view token = rest.substr(rest.rfind('/') + 1);
    rest.remove_suffix(token.size() + 1);
    const bool is_index = !token.empty() && token.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_index) return (is_item ? "an item of '" : "'") + std::string(token) + '\'';
    is_item = true;
  }
  return is_item ? "an item" : "the file";
}

}  // namespace alignability::detail
