// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace alignability::cli {

/// Lets every option that takes numbers refuse what CLI11 lets pass or words badly: NaN, the infinities, a minus that an unsigned number
/// would wrap around. Call it when all commands are there.
void refuse_what_is_no_number(CLI::App& app);

}  // namespace alignability::cli
