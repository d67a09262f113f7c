// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/collada_check.hpp"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

struct Check {
  XML_Parser parser;
  std::size_t largest;
  std::string fault;
};

bool names_a_size(std::string_view attribute) {
  static constexpr std::string_view kNames[]{"count", "stride", "offset", "set"};
  return std::ranges::find(kNames, attribute) != std::end(kNames);
}

bool is_at_most(std::string_view text, std::size_t largest) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value <= largest;
}

// Exceptions must not pass through the parser: the fault is kept until it has returned.
void check_attributes(void* user_data, const XML_Char*, const XML_Char** attributes) {
  Check& check = *static_cast<Check*>(user_data);
  for (; attributes[0] != nullptr && check.fault.empty(); attributes += 2) {
    if (!names_a_size(attributes[0]) || is_at_most(attributes[1], check.largest)) continue;
    check.fault =
        "'" + std::string(attributes[0]) + "' cannot be '" + attributes[1] + "' in a file of " + std::to_string(check.largest) + " bytes";
    XML_StopParser(check.parser, XML_FALSE);
  }
}

}  // namespace

void check_collada(std::string_view bytes, const std::filesystem::path& file) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr), &XML_ParserFree);
  Check check{.parser = parser.get(), .largest = bytes.size(), .fault = {}};
  XML_SetUserData(parser.get(), &check);
  XML_SetStartElementHandler(parser.get(), &check_attributes);
  if (XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) == XML_STATUS_ERROR && check.fault.empty()) {
    check.fault = std::string("not valid XML: ") + XML_ErrorString(XML_GetErrorCode(parser.get()));
  }
  if (!check.fault.empty()) throw InputError(file, {static_cast<int>(XML_GetCurrentLineNumber(parser.get())), 0}, check.fault);
}

}  // namespace alignability::detail
