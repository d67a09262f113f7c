// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <map>

#include "cli/command.hpp"
#include "cli/completion.hpp"

namespace alignability::cli {

void add_completion(CLI::App& app, Work& work) {
  using Writer = std::string (*)(const CommandReference&);
  static const std::map<std::string, Writer> kWriters{{"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "Print a script that makes a shell complete these commands");
  command->add_option("shell", *shell, "bash, fish or zsh")->required()->check(CLI::IsMember({"bash", "fish", "zsh"}));
  command->footer(
      "Examples:\n"
      "  alignability completion bash > ~/.local/share/bash-completion/completions/alignability\n"
      "  alignability completion zsh > ~/.zfunc/_alignability\n"
      "  alignability completion fish > ~/.config/fish/completions/alignability.fish\n"
      "For zsh, ~/.zfunc must be in fpath before compinit runs. Packages install all three.");
  command->callback([shell, &app, &work] {
    work = [shell, &app] {
      std::cout << kWriters.at(*shell)(reference_of(app));
      return kYes;
    };
  });
}

}  // namespace alignability::cli
