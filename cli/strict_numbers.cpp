// SPDX-License-Identifier: BSD-3-Clause
#include "cli/strict_numbers.hpp"

#include <charconv>
#include <cstdint>
#include <optional>

#include "core/range.hpp"

namespace alignability::cli {
namespace {

template <typename Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

// What is wrong with a word, "" when nothing is: CLI11's form of a check.
std::string fault_of(const std::string& word, const Range& allowed) {
  const auto value = number_in<double>(word);
  return value && allowed.contains(*value) ? "" : "must be " + allowed.description() + ", not " + word;
}

template <typename Integer>
std::string fault_of_integer(const std::string& word, const char* least) {
  return number_in<Integer>(word) ? "" : std::string("must be a whole number") + least + ", not " + word;
}

// The check for what an option's type, as the help shows it, says of its values: FLOAT:NONNEGATIVE.
std::function<std::string(std::string&)> check_for(const std::string& type) {
  const bool not_negative = type.find("NONNEGATIVE") != std::string::npos;
  const bool positive = type.find("POSITIVE") != std::string::npos;
  const char* least = positive ? " greater than 0" : not_negative ? " of at least 0" : "";
  if (type.starts_with("FLOAT")) {
    return [range = positive ? kPositive : not_negative ? kNotNegative : kFinite](std::string& word) { return fault_of(word, range); };
  }
  if (type.starts_with("UINT") || (type.starts_with("INT") && not_negative)) {
    return [least](std::string& word) { return fault_of_integer<std::uint64_t>(word, least); };
  }
  if (type.starts_with("INT")) return [least](std::string& word) { return fault_of_integer<std::int64_t>(word, least); };
  return {};
}

}  // namespace

void refuse_what_is_no_number(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    refuse_what_is_no_number(*command);
    for (CLI::Option* option : command->get_options()) {
      // A transformation, though it changes nothing, for those come before all checks.
      if (const auto check = check_for(option->get_type_name())) option->transform(CLI::Validator(check, ""));
    }
  }
}

}  // namespace alignability::cli
