// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/exit_code.hpp"

namespace alignability::cli {

/// The work of the command that was asked for; set by its callback, run by main.
using Work = std::function<int()>;

// Each adds a subcommand with its options and examples; the command sets `work` when it is chosen. Those that write a report put
// the command line into it.
void add_occupancy(CLI::App& app, Work& work);
void add_scan(CLI::App& app, Work& work);
void add_sample(CLI::App& app, Work& work);
void add_score(CLI::App& app, Work& work);
void add_explain(CLI::App& app, Work& work);
void add_map(CLI::App& app, Work& work);
void add_join(CLI::App& app, Work& work);
void add_compare_maps(CLI::App& app, Work& work);
void add_plan(CLI::App& app, Work& work);
void add_compare(CLI::App& app, Work& work, const std::string& command_line);
void add_evaluate(CLI::App& app, Work& work);
void add_export(CLI::App& app, Work& work);
void add_report(CLI::App& app, Work& work, const std::string& command_line);
void add_validate(CLI::App& app, Work& work);
void add_calibrate(CLI::App& app, Work& work);
void add_completion(CLI::App& app, Work& work);

}  // namespace alignability::cli
