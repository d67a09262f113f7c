// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/collada_check.hpp"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/input_error.hpp"
#include "core/range.hpp"

namespace alignability::detail {
namespace {

constexpr std::string_view kSizes[]{"count", "stride", "offset", "set"};
constexpr std::string_view kUpAxes[]{"X_UP", "Y_UP", "Z_UP"};

template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

// Listens to the parser. Exceptions must not pass through it: a fault is kept until it has returned.
class Check {
 public:
  Check(std::string_view bytes, const std::filesystem::path& file) : file_(file), largest_(bytes.size()) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) { static_cast<Check*>(self)->start(name, attributes); },
        [](void* self, const XML_Char* name) { static_cast<Check*>(self)->end(name); });
    XML_SetCharacterDataHandler(
        parser_.get(), [](void* self, const XML_Char* text, int length) { static_cast<Check*>(self)->text_.append(text, length); });
    if (XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) == XML_STATUS_ERROR && fault_.empty()) {
      stop(std::string("not valid XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())));
    }
    if (!fault_.empty()) throw InputError(file_, fault_position_, fault_);
    for (const auto& [url, position] : instances_) {
      if (!geometries_.contains(url)) throw InputError(file_, position, "no <geometry> of this file is '" + url + "'");
    }
  }

 private:
  TextPosition position() const {
    return {static_cast<int>(XML_GetCurrentLineNumber(parser_.get())), static_cast<int>(XML_GetCurrentColumnNumber(parser_.get())) + 1};
  }

  void stop(std::string fault) {
    if (!fault_.empty()) return;
    fault_ = std::move(fault);
    fault_position_ = position();
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void start(std::string_view element, const XML_Char** attributes) {
    if (std::exchange(in_root_, true) == false && element != "COLLADA")
      return stop("expected <COLLADA>, not <" + std::string(element) + ">");
    text_.clear();
    for (; attributes[0] != nullptr; attributes += 2) check_attribute(element, attributes[0], attributes[1]);
  }

  void check_attribute(std::string_view element, std::string_view name, const std::string& value) {
    if (std::ranges::find(kSizes, name) != std::end(kSizes) && number_in<std::size_t>(value).value_or(largest_ + 1) > largest_) {
      stop("'" + std::string(name) + "' cannot be '" + value + "' in a file of " + std::to_string(largest_) + " bytes");
    }
    if (element == "unit" && name == "meter" && !kPositive.contains(number_in<double>(value).value_or(0.0))) {
      stop("'meter' must be " + kPositive.description() + ", not '" + value + "'");
    }
    if (element == "geometry" && name == "id") geometries_.insert("#" + value);
    if (element == "instance_geometry" && name == "url") instances_.emplace_back(value, position());
  }

  void end(std::string_view element) {
    const std::string axis = trimmed(text_);
    if (element == "up_axis" && std::ranges::find(kUpAxes, axis) == std::end(kUpAxes)) {
      stop("'up_axis' is '" + axis + "', which is none of: X_UP, Y_UP, Z_UP");
    }
    text_.clear();
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_{XML_ParserCreate(nullptr), &XML_ParserFree};
  std::filesystem::path file_;
  std::size_t largest_;
  bool in_root_ = false;
  std::string text_;
  std::set<std::string> geometries_;
  std::vector<std::pair<std::string, TextPosition>> instances_;
  std::string fault_;
  TextPosition fault_position_;
};

}  // namespace

void check_collada(std::string_view bytes, const std::filesystem::path& file) { const Check check(bytes, file); }

}  // namespace alignability::detail
