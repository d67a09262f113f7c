// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "alignability/alignability.hpp"

namespace alignability::cli {

/// Adds what says how scans are scored: --engine, --stride, --centred, --readings.
void add_scoring_options(CLI::App& command, AlignabilityOptions& options);

}  // namespace alignability::cli
