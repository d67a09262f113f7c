// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "cli/output_name.hpp"

namespace alignability::cli {

/// `--pictures`, for a command that has its `--output` already.
void add_picture_option(CLI::App& command, PictureKinds& kinds);

}  // namespace alignability::cli
