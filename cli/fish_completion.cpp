// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "cli/completion.hpp"

namespace alignability::cli {
namespace {

constexpr const char* kBegin = R"(# fish completion for alignability; made from its --help.

function __alignability_at --argument-names wanted
    set -l command alignability
    for word in (commandline -opc)
        switch "$command $word"
            case )";

constexpr const char* kEnd = R"(
                set command "$command $word"
        end
    end
    test "$command" = "$wanted"
end

complete -c alignability -f
)";

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + '\'';
}

std::string files(const std::vector<std::string>& extensions) {
  if (extensions.front() == "/") return " -a '(__fish_complete_directories)'";
  return " -k -a '(__fish_complete_suffix ." + extensions.front() + ")'";
}

std::string values_of(const OptionReference& option) {
  const std::string words = joined(option.choices, " ");
  const std::vector<std::string> extensions = file_extensions(option);
  if (!words.empty() && option.is_list) return " -x -a " + quoted("(__fish_complete_list , \"string join \\n " + words + "\")");
  if (!words.empty()) return " -x -a " + quoted(words);
  if (extensions.empty()) return " -x";
  return extensions.front() == "*" ? " -r -F" : " -x" + files(extensions);
}

std::string arguments_of(const OptionReference& option) {
  const std::vector<std::string> extensions = file_extensions(option);
  if (!option.choices.empty()) return " -a " + quoted(joined(option.choices, " "));
  if (extensions.empty()) return "";
  return extensions.front() == "*" ? " -F" : files(extensions);
}

std::string names_of(const OptionReference& option) {
  std::string names;
  for (const std::string& name : option.names) names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return names;
}

void add_options(std::ostream& out, const CommandReference& command) {
  const std::string begin = "complete -c alignability -n " + quoted("__alignability_at \"" + joined(command.words, " ") + '"');
  out << '\n';
  for (const CommandReference& beneath : command.commands) {
    out << begin << " -a " << beneath.words.back() << " -d " << quoted(beneath.text) << '\n';
  }
  for (const OptionReference& option : command.options) {
    if (option.is_positional) {
      if (const std::string arguments = arguments_of(option); !arguments.empty()) out << begin << arguments << '\n';
      continue;
    }
    out << begin << names_of(option) << (option.most_values == 0 ? "" : values_of(option)) << " -d " << quoted(option.text) << '\n';
  }
}

}  // namespace

std::string fish_completion(const CommandReference& program) {
  std::ostringstream out;
  std::vector<std::string> commands;
  for (const CommandReference* command : flattened(program)) {
    if (command != &program) commands.push_back(quoted(joined(command->words, " ")));
  }
  out << kBegin << joined(commands, " ") << kEnd;
  for (const CommandReference* command : flattened(program)) add_options(out, *command);
  return out.str();
}

}  // namespace alignability::cli
