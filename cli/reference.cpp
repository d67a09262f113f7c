// SPDX-License-Identifier: BSD-3-Clause
#include "cli/reference.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

#include "localization/localizer.hpp"
#include "planner/planners.hpp"

namespace alignability::cli {
namespace {

std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, between);) parts.push_back(part);
  return parts;
}

std::vector<std::string> localizer_names() {
  std::vector<std::string> names;
  for (const auto& [name, localizer] : kLocalizers) names.emplace_back(name);
  return names;
}

// "TEXT:{png,svg,pdf}" as CLI11 names what IsMember checks, "visual|collision", or a type that has names.
std::vector<std::string> choices_of(const std::string& type) {
  if (type == "PLANNER") return planner_names();
  if (type == "LOCALIZER") return localizer_names();
  if (const std::size_t brace = type.find('{'); brace != std::string::npos) {
    return split(type.substr(brace + 1, type.find('}') - brace - 1), ',');
  }
  return type.find('|') == std::string::npos ? std::vector<std::string>{} : split(type, '|');
}

// "FLOAT" of "FLOAT:POSITIVE"; what has choices is a WORD.
std::string value_of(const std::string& type) {
  if (type.find_first_of("{|") != std::string::npos) return "WORD";
  return type.substr(0, type.find_first_of(":, "));
}

// "greater than 0" of "FLOAT:POSITIVE", "1 to 4" of "INT:INT in [1 - 4]", "" of a type without bounds.
std::string bounds_of(const std::string& type) {
  if (type.ends_with(":POSITIVE")) return "greater than 0";
  if (type.ends_with(":NONNEGATIVE")) return "at least 0";
  const std::size_t from = type.find("in [");
  const std::size_t to = type.find(" - ");
  if (from == std::string::npos || to == std::string::npos) return "";
  std::string bounds = type.substr(from + 4, to - from - 4);
  bounds += " to ";
  bounds += type.substr(to + 3, type.find(']', to) - to - 3);
  return bounds;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  if (!option.nonpositional()) return {option.get_name(true)};
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::ranges::sort(names);
  return names;
}

OptionReference reference_of(const CLI::Option& option) {
  OptionReference reference;
  reference.names = names_of(option);
  reference.is_positional = !option.nonpositional();
  reference.is_required = option.get_required();
  reference.most_values = option.get_items_expected_max();
  if (!option.get_allow_extra_args()) reference.most_values = std::min(reference.most_values, 1);
  reference.is_list = option.get_delimiter() != '\0';
  reference.text = option.get_description();
  reference.needs = names_of(option.get_needs());
  reference.excludes = names_of(option.get_excludes());
  if (reference.most_values == 0) return reference;
  const std::string type = option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
  reference.value = value_of(type);
  reference.choices = choices_of(type);
  reference.bounds = bounds_of(type);
  reference.default_value = option.get_default_str();
  return reference;
}

}  // namespace

CommandReference reference_of(const CLI::App& app) {
  CommandReference reference;
  for (const CLI::App* at = &app; at != nullptr; at = at->get_parent()) reference.words.insert(reference.words.begin(), at->get_name());
  reference.text = app.get_description();
  reference.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) reference.options.push_back(reference_of(*option));
  for (const CLI::App* command : app.get_subcommands({})) reference.commands.push_back(reference_of(*command));
  return reference;
}

std::vector<const CommandReference*> flattened(const CommandReference& command) {
  std::vector<const CommandReference*> all{&command};
  for (const CommandReference& beneath : command.commands) std::ranges::copy(flattened(beneath), std::back_inserter(all));
  return all;
}

std::vector<std::string> file_extensions(const OptionReference& option) {
  static const std::map<std::string, std::vector<std::string>> kExtensions{{"YAML", {"yaml", "yml"}}, {"CSV", {"csv"}}, {"FILE", {"*"}},
                                                                           {"PATH", {"*"}},           {"NAME", {"*"}},  {"FOLDER", {"/"}}};
  const auto found = kExtensions.find(option.value);
  return found == kExtensions.end() ? std::vector<std::string>{} : found->second;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

}  // namespace alignability::cli
