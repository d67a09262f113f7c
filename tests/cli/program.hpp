// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alignability::test {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

struct Signal {
  double after = 0.0;  ///< [s]
  int number = SIGINT;
};

/// Runs the program with these arguments in a folder, and sends it a signal if it lasts that long. Its exit code is 128 + the signal's
/// number when it ended by one.
Outcome run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                    std::optional<Signal> signal = std::nullopt);

}  // namespace alignability::test
