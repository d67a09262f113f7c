// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/failure.hpp"
#include "cli/launcher.hpp"
#include "cli/library_logs.hpp"
#include "cli/report_output.hpp"
#include "core/input_error.hpp"

namespace {

using namespace alignability;
using namespace alignability::cli;

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool looks_like_an_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '.' && std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

// "unknown option '…' (did you mean …?)" for the first word that is none of the command, "" when there is none.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& words) {
  const std::vector<std::string> names = option_names(command);
  for (const std::string& word : words) {
    if (!looks_like_an_option(word)) continue;
    const bool is_long = word.starts_with("--");
    const std::string name = is_long ? word.substr(0, word.find('=')) : word.substr(0, 2);
    if (std::ranges::find(names, name) != names.end()) continue;
    return "unknown option '" + name + '\'' + (is_long ? did_you_mean(name, names) : "");
  }
  return {};
}

// The likeliest cause of a wrong command line is a misspelt word, so those are looked for before CLI11 is heard.
std::string fault_of(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::size_t depth = 0;
  for (; !command->get_subcommands().empty(); ++depth) command = command->get_subcommands().front();
  const std::vector<std::string> names = command_names(*command);
  if (!names.empty() && depth < words.size() && !words[depth].starts_with("-")) {
    return "unknown command '" + words[depth] + '\'' + did_you_mean(words[depth], names);
  }
  const std::string unknown = unknown_option(*command, words);
  return unknown.empty() ? error.what() : unknown;
}

int report(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error) == 0 ? kYes : kBadInput;
  return run_telling([&]() -> int { throw std::runtime_error(fault_of(app, error, words) + "\nRun with --help for more information."); });
}

// Of a command that cannot be spread over processes, where several were started.
Work for_one_process(const std::string& command, const Work& work) {
  return [command, work] {
    refuse_several_processes("'" + command + "'");
    return work();
  };
}

}  // namespace

int main(int argc, char** argv) {
  Work work;
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::unique_ptr<CLI::App> app = command_line(work, "alignability " + shell_line(words));
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(*app, error, words);
  }
  const LibraryLogs library_logs;
  const std::string command = app->get_subcommands().front()->get_name();
  return run_telling(command == "map" ? work : for_one_process(command, work));
}
