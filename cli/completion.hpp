// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/reference.hpp"

namespace alignability::cli {

// Scripts that a shell sources, or finds where it looks for them, to complete commands, options, words and files.
std::string bash_completion(const CommandReference& program);
std::string zsh_completion(const CommandReference& program);
std::string fish_completion(const CommandReference& program);

}  // namespace alignability::cli
