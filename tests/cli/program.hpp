// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alignability::test {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the program with these arguments in a folder. After `interrupt_after` seconds, if positive, sends it SIGINT.
Outcome run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder, double interrupt_after = 0.0);

}  // namespace alignability::test
