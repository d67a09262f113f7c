// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.hpp"

#include "cli/strict_numbers.hpp"

namespace alignability::cli {

std::unique_ptr<CLI::App> command_line(Work& work, const std::string& as_typed) {
  auto app = std::make_unique<CLI::App>(
      "How well a lidar scan constrains alignment: maps of it, and paths on which a robot stays localized.", "alignability");
  app->set_version_flag("--version", ALIGNABILITY_VERSION);
  app->require_subcommand(1);
  app->get_formatter()->column_width(34);
  add_occupancy(*app, work);
  add_scan(*app, work);
  add_sample(*app, work);
  add_score(*app, work);
  add_explain(*app, work);
  add_map(*app, work);
  add_join(*app, work);
  add_compare_maps(*app, work);
  add_plan(*app, work);
  add_compare(*app, work, as_typed);
  add_evaluate(*app, work);
  add_export(*app, work);
  add_report(*app, work, as_typed);
  add_validate(*app, work);
  add_calibrate(*app, work);
  add_completion(*app, work);
  refuse_what_is_no_number(*app);
  return app;
}

}  // namespace alignability::cli
