// SPDX-License-Identifier: BSD-3-Clause
#include "cli/man_page.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <span>
#include <sstream>

namespace alignability::cli {
namespace {

constexpr const char* kExitStatus = R"(.SH EXIT STATUS
.TP
.B 0
The answer is yes: it was done, there is a path, a check held.
.TP
.B 1
The answer is no: there is no path, or a check failed.
.TP
.B 2
The command line or a file is wrong; what is wrong is told on standard error, with file and line.
.TP
.B 130
Interrupted. No file is left half written.
)";

// The code point that starts at `at`, and moves `at` past it; the text is UTF-8.
std::uint32_t next_code_point(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at++);
  if (first < 0x80) return first;
  std::uint32_t code = first >= 0xf0 ? first & 0x07u : first >= 0xe0 ? first & 0x0fu : first & 0x1fu;
  while (at < text.size() && (byte(at) & 0xc0u) == 0x80u) code = code << 6 | (byte(at++) & 0x3fu);
  return code;
}

std::string escape_of(std::uint32_t code) {
  switch (code) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '"':
      return "\\(dq";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    case '`':
      return "\\(ga";
    default:
      break;
  }
  if (code < 0x80) return std::string(1, static_cast<char>(code));
  char escape[16];
  std::snprintf(escape, sizeof escape, "\\[u%04X]", static_cast<unsigned int>(code));
  return escape;
}

std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) out += escape_of(next_code_point(text, at));
  // A dot at the beginning of a line would be a request.
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string in_sentence_case(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

// "-o NAME", "problem", "--cells UINT ..."
std::string usage_of(const OptionReference& option) {
  const std::string more = option.most_values > 1 && !option.is_list ? " ..." : "";
  if (option.is_positional) return italic(option.names.front()) + more;
  return bold(option.names.front()) + (option.value.empty() ? "" : ' ' + italic(option.value)) + more;
}

void add_synopsis(std::ostream& out, const CommandReference& command) {
  out << ".SH SYNOPSIS\n" << bold(joined(command.words, " ")) << '\n';
  if (!command.commands.empty()) out << "\\fIcommand\\fR ...\n";
  for (const bool is_positional : {true, false}) {
    for (const OptionReference& option : command.options) {
      if (option.is_positional != is_positional || (!is_positional && !option.is_required)) continue;
      out << (option.is_required ? usage_of(option) : '[' + usage_of(option) + ']') << '\n';
    }
  }
  out << "[\\fIoptions\\fR]\n";
}

std::string remarks_on(const OptionReference& option) {
  std::string remarks;
  const auto add = [&remarks](const std::string& remark) { remarks += ' ' + remark + '.'; };
  if (!option.choices.empty()) {
    add((option.is_list ? "Any of " : "One of ") + roff(joined(option.choices, ", ")));
  }
  if (!option.bounds.empty()) add(in_sentence_case(roff(option.bounds)));
  if (!option.default_value.empty()) add("Default: " + roff(option.default_value));
  if (!option.needs.empty()) add("Needs " + roff(joined(option.needs, ", ")));
  if (!option.excludes.empty()) add("Not with " + roff(joined(option.excludes, ", ")));
  if (option.is_required) add("Required");
  return remarks;
}

void add_option(std::ostream& out, const OptionReference& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(option.is_positional ? italic(name) : bold(name));
  out << ".TP\n" << joined(names, ", ");
  if (!option.is_positional && !option.value.empty()) out << ' ' << italic(option.value);
  const bool ends = option.text.ends_with('.') || option.text.empty();
  out << '\n' << roff(option.text) << (ends ? "" : ".") << remarks_on(option) << '\n';
}

void add_options(std::ostream& out, const CommandReference& command, bool is_positional, const char* heading) {
  bool is_first = true;
  for (const OptionReference& option : command.options) {
    if (option.is_positional != is_positional) continue;
    if (is_first) out << ".SH " << heading << '\n';
    is_first = false;
    add_option(out, option);
  }
}

void add_commands(std::ostream& out, const CommandReference& command) {
  if (command.commands.empty()) return;
  out << ".SH COMMANDS\n";
  for (const CommandReference& beneath : command.commands) {
    out << ".TP\n" << bold(beneath.words.back()) << '\n' << roff(beneath.text) << ".\n";
  }
}

// Indented lines are commands, the others remarks on them.
void add_examples(std::ostream& out, const CommandReference& command) {
  if (command.footer.empty()) return;
  out << ".SH EXAMPLES\n";
  std::istringstream lines(command.footer);
  bool verbatim = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Example")) continue;
    const bool is_command = line.starts_with("  ");
    if (is_command != verbatim) out << (is_command ? ".nf\n" : ".fi\n.PP\n");
    verbatim = is_command;
    out << roff(is_command ? line.substr(2) : line) << '\n';
  }
  if (verbatim) out << ".fi\n";
}

void add_see_also(std::ostream& out, const CommandReference& command, const CommandReference& program) {
  std::vector<std::string> names;
  for (const CommandReference* other : flattened(program)) {
    const bool is_parent = other->words.size() + 1 == command.words.size();
    const bool is_beneath = other->words.size() == command.words.size() + 1 &&
                            std::ranges::equal(command.words, std::span(other->words).first(command.words.size()));
    const bool is_neighbour = other->words.size() == command.words.size() && other != &command &&
                              other->words[other->words.size() - 2] == command.words[command.words.size() - 2];
    if (is_parent || is_beneath || is_neighbour) names.push_back(bold(man_page_name(*other)) + "(1)");
  }
  if (!names.empty()) out << ".SH SEE ALSO\n" << joined(names, ",\n") << '\n';
}

}  // namespace

std::string man_page_name(const CommandReference& command) { return joined(command.words, "-"); }

std::string man_page(const CommandReference& command, const CommandReference& program, const std::string& version) {
  std::ostringstream out;
  out << ".\\\" Made from alignability --help.\n.TH " << in_capitals(roff(man_page_name(command))) << " 1 \"\" \"alignability " << version
      << "\" \"User Commands\"\n.nh\n.ad l\n.SH NAME\n"
      << roff(man_page_name(command)) << " \\- " << roff(command.text) << '\n';
  add_synopsis(out, command);
  out << ".SH DESCRIPTION\n" << roff(command.text) << (command.text.ends_with('.') ? "" : ".") << '\n';
  add_commands(out, command);
  add_options(out, command, true, "ARGUMENTS");
  add_options(out, command, false, "OPTIONS");
  add_examples(out, command);
  out << kExitStatus;
  add_see_also(out, command, program);
  return out.str();
}

}  // namespace alignability::cli
