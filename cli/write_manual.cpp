// SPDX-License-Identifier: BSD-3-Clause
// Run by the build: writes what is installed beside the program, its man pages and completions, into a folder.
#include <exception>
#include <filesystem>
#include <iostream>

#include "cli/command_line.hpp"
#include "cli/completion.hpp"
#include "cli/man_page.hpp"
#include "core/file.hpp"

int main(int argc, char** argv) {
  using namespace alignability;
  using namespace alignability::cli;
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return kBadInput;
  }
  try {
    const std::filesystem::path folder = argv[1];
    for (const char* part : {"man", "bash", "zsh", "fish"}) std::filesystem::create_directories(folder / part);
    Work work;
    const std::unique_ptr<CLI::App> app = command_line(work, "");
    const CommandReference program = reference_of(*app);
    for (const CommandReference* command : flattened(program)) {
      write_file(folder / "man" / (man_page_name(*command) + ".1"), man_page(*command, program, ALIGNABILITY_VERSION));
    }
    write_file(folder / "bash" / "alignability", bash_completion(program));
    write_file(folder / "zsh" / "_alignability", zsh_completion(program));
    write_file(folder / "fish" / "alignability.fish", fish_completion(program));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return kBadInput;
  }
}
