// SPDX-License-Identifier: BSD-3-Clause
#include "cli/library_logs.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_alignability, module) {
  using namespace alignability;
  // What OMPL warns of goes to stderr, as with the program; until the interpreter ends.
  static const auto* const library_logs = new cli::LibraryLogs;
  static_cast<void>(library_logs);
  module.attr("__version__") = ALIGNABILITY_VERSION;
  python::bind_errors(module);
  python::bind_maps(module);
  python::bind_scene(module);
  python::bind_score(module);
  python::bind_build_map(module);
  python::bind_problem(module);
  python::bind_plan(module);
  python::bind_risk(module);
  python::bind_validate(module);
}
