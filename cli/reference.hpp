// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace alignability::cli {

/// What --help says of an option or a positional argument, in parts.
struct OptionReference {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional argument its name alone
  bool is_positional = false;
  bool is_required = false;
  int most_values = 0;               ///< 0 of a flag
  bool is_list = false;              ///< values may be one word, apart by commas
  std::string value;                 ///< "YAML", "FLOAT"; "" of a flag
  std::vector<std::string> choices;  ///< all values that there are, if they can be told
  std::string bounds;                ///< of numbers, in words
  std::string default_value;
  std::vector<std::string> needs;     ///< names of other options
  std::vector<std::string> excludes;  ///< names of other options
  std::string text;
};

/// A command, or the program itself.
struct CommandReference {
  std::vector<std::string> words;  ///< "alignability", "validate", "map"
  std::string text;
  std::string footer;  ///< the examples, and remarks on them
  std::vector<OptionReference> options;
  std::vector<CommandReference> commands;
};

/// Takes a command line apart; what completions and man pages are made from, so that they say what --help says.
CommandReference reference_of(const CLI::App& app);

/// The command and all beneath it, each before those beneath it.
std::vector<const CommandReference*> flattened(const CommandReference& command);

/// Extensions of the files that a value names: "yaml", "yml"; "*" for any, "/" for folders alone; none where it is no file.
std::vector<std::string> file_extensions(const OptionReference& option);

std::string joined(const std::vector<std::string>& words, const std::string& between);

}  // namespace alignability::cli
