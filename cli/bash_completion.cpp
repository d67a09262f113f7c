// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <sstream>

#include "cli/completion.hpp"

namespace alignability::cli {
namespace {

constexpr const char* kBegin = R"(# bash completion for alignability; made from its --help.

_alignability_files() {  # of these extensions: * of any, / folders alone
  local extension
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
  for extension; do
    case $extension in
      /) ;;
      '*') mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
      *) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -X "!*.$extension" -- "$cur") ;;
    esac
  done
}

_alignability_words() {
  mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur")
}

_alignability_list() {  # of such words, apart by commas
  local before=
  [[ $cur == *,* ]] && before=${cur%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$*" -- "${cur##*,}")
}

_alignability() {
  local cur=${COMP_WORDS[COMP_CWORD]} command=alignability option= nth=0 i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)";

// The last option before the word, and how many words after it that one stands; "=" is a word of its own to bash.
constexpr const char* kOption = R"(    esac
    case ${COMP_WORDS[i]} in
      =) ;;
      -[!0-9.]*) option=${COMP_WORDS[i]} nth=0 ;;
      *) ((++nth)) ;;
    esac
  done
  ((++nth))
  [[ $cur == = ]] && cur=
  case "$command $option" in
)";

constexpr const char* kEnd = R"(  esac
}

complete -F _alignability alignability
)";

std::string completion_of(const OptionReference& option) {
  if (!option.choices.empty()) return (option.is_list ? "_alignability_list " : "_alignability_words ") + joined(option.choices, " ");
  std::vector<std::string> extensions = file_extensions(option);
  if (extensions.empty()) return "";
  for (std::string& extension : extensions) extension = '\'' + extension + '\'';
  return "_alignability_files " + joined(extensions, " ");
}

// Where the word is one of the option's values, what it may be.
void add_values(std::ostream& out, const std::string& command, const OptionReference& option) {
  if (option.most_values == 0 || option.is_positional) return;
  std::vector<std::string> patterns;
  for (const std::string& name : option.names) patterns.push_back('\'' + command + ' ' + name + '\'');
  const std::string completion = completion_of(option);
  out << "    " << joined(patterns, " | ") << ") ((nth <= " << option.most_values << ")) && { " << completion
      << (completion.empty() ? "" : "; ") << "return; } ;;\n";
}

// What the words that belong to no option may be: as much as any positional argument.
std::string completion_of_arguments(const CommandReference& command) {
  if (!command.commands.empty()) {
    std::vector<std::string> names;
    for (const CommandReference& beneath : command.commands) names.push_back(beneath.words.back());
    return "_alignability_words " + joined(names, " ");
  }
  std::vector<std::string> extensions;
  for (const OptionReference& option : command.options) {
    if (!option.is_positional) continue;
    if (!option.choices.empty()) return completion_of(option);
    for (const std::string& extension : file_extensions(option)) {
      const std::string quoted = '\'' + extension + '\'';
      if (std::ranges::find(extensions, quoted) == extensions.end()) extensions.push_back(quoted);
    }
  }
  return extensions.empty() ? ":" : "_alignability_files " + joined(extensions, " ");
}

std::string option_names(const CommandReference& command) {
  std::vector<std::string> names;
  for (const OptionReference& option : command.options) {
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return joined(names, " ");
}

}  // namespace

std::string bash_completion(const CommandReference& program) {
  std::ostringstream out;
  const std::vector<const CommandReference*> commands = flattened(program);
  out << kBegin;
  for (const CommandReference* command : commands) {
    const std::string words = joined(command->words, " ");
    if (command != &program) out << "      '" << words << "') command='" << words << "' option= nth=0; continue ;;\n";
  }
  out << kOption;
  for (const CommandReference* command : commands) {
    for (const OptionReference& option : command->options) add_values(out, joined(command->words, " "), option);
  }
  out << "  esac\n  case $command in\n";
  for (const CommandReference* command : commands) {
    out << "    '" << joined(command->words, " ") << "')\n      if [[ $cur == -* ]]; then _alignability_words " << option_names(*command)
        << "\n      else " << completion_of_arguments(*command) << "\n      fi\n      ;;\n";
  }
  out << kEnd;
  return out.str();
}

}  // namespace alignability::cli
