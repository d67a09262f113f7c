// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "cli/command.hpp"

namespace alignability::cli {

/// The whole command line: every command with its options and help. `as_typed` is what the user wrote, for pages that tell how they were
/// made. `work` and what is returned refer to each other: both stay.
std::unique_ptr<CLI::App> command_line(Work& work, const std::string& as_typed);

}  // namespace alignability::cli
