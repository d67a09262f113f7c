// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace alignability::cli {

/// What mpirun, srun and their like say in the environment of each process that they start.
struct Launch {
  int rank = 0;                  ///< of this process, from 0
  std::optional<int> processes;  ///< where the launcher says how many
};

/// Nothing where no launcher started this process.
std::optional<Launch> launched();

/// Throws std::runtime_error, saying that `what` is the work of one process, where a launcher started several.
void refuse_several_processes(const std::string& what);

}  // namespace alignability::cli
