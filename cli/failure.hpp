// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <string>

namespace alignability::cli {

/// What an exception says to a user.
std::string sentence_of(const std::exception& error);

/// Runs a command's work, tells on stderr of what it throws, and gives the exit code. Of several processes that a launcher started, the
/// first alone tells.
int run_telling(const std::function<int()>& work);

}  // namespace alignability::cli
