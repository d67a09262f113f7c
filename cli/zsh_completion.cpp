// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <sstream>

#include "cli/completion.hpp"

namespace alignability::cli {
namespace {

constexpr const char* kBegin = R"(#compdef alignability
# zsh completion for alignability; made from its --help.
)";

// Loaded by compinit the file is the function; sourced it is asked to be one.
constexpr const char* kEnd = R"(
if [[ $funcstack[1] == _alignability ]]; then
  _alignability "$@"
else
  compdef _alignability alignability
fi
)";

// For a part of a specification of _arguments, which stands in single quotes.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (std::string("\\[]:$`").find(c) != std::string::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string action_of(const OptionReference& option) {
  const std::string words = joined(option.choices, " ");
  if (!option.choices.empty()) return option.is_list ? "_values -s , " + option.value + ' ' + words : '(' + words + ')';
  const std::vector<std::string> extensions = file_extensions(option);
  if (extensions.empty()) return " ";
  if (extensions.front() == "*") return "_files";
  if (extensions.front() == "/") return "_files -/";
  return "_files -g \"*.(" + joined(extensions, "|") + ")\"";
}

// ":YAML:_files", as often as there are values; lists without an end take one at a time.
std::string values_of(const OptionReference& option) {
  constexpr int kEndless = 100;
  std::string values;
  const int count = option.is_list || option.most_values > kEndless ? 1 : option.most_values;
  for (int i = 0; i < count; ++i) values += ':' + escaped(option.value) + ':' + action_of(option);
  return values;
}

std::string specification(const OptionReference& option) {
  if (option.is_positional) {
    return std::string(option.most_values > 1 && !option.is_list ? "'*:" : "':") + escaped(option.names.front()) + ':' + action_of(option) +
           '\'';
  }
  const std::string rest = '[' + escaped(option.text) + ']' + values_of(option) + '\'';
  std::string specifications;
  for (const std::string& name : option.names) {
    const std::string takes = option.most_values == 0 ? "" : name.starts_with("--") ? "=" : "+";
    if (!specifications.empty()) specifications += " \\\n    ";
    specifications += (option.names.size() > 1 ? "'(" + joined(option.names, " ") + ')' : "'") + name + takes + rest;
  }
  return specifications;
}

std::string function_of(const CommandReference& command) { return '_' + joined(command.words, "_"); }

void add_commands(std::ostream& out, const CommandReference& command) {
  out << " \\\n    ':command:->commands' \\\n    '*:: :->arguments'\n  case $state in\n    commands)\n      local -a commands=(\n";
  for (const CommandReference& beneath : command.commands) {
    out << "        '" << beneath.words.back() << ':' << escaped(beneath.text) << "'\n";
  }
  out << "      )\n      _describe command commands\n      ;;\n    arguments)\n      (( $+functions[" << function_of(command)
      << "_$line[1]] )) && " << function_of(command) << "_$line[1]\n      ;;\n  esac\n";
}

}  // namespace

std::string zsh_completion(const CommandReference& program) {
  std::ostringstream out;
  out << kBegin;
  for (const CommandReference* command : flattened(program)) {
    out << '\n' << function_of(*command) << "() {\n";
    if (!command->commands.empty()) out << "  local context state state_descr line\n  typeset -A opt_args\n";
    out << "  _arguments" << (command->commands.empty() ? "" : " -C");
    for (const OptionReference& option : command->options) out << " \\\n    " << specification(option);
    if (command->commands.empty()) {
      out << '\n';
    } else {
      add_commands(out, *command);
    }
    out << "}\n";
  }
  out << kEnd;
  return out.str();
}

}  // namespace alignability::cli
