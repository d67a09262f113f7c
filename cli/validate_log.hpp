// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "cli/command.hpp"

namespace alignability::cli {

/// Adds `validate log`: recorded scans against what the lidar sees of a site from their poses.
void add_validate_log(CLI::App& validate, Work& work);

}  // namespace alignability::cli
