// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability::cli {

/// What the program says when it ends.
enum ExitCode { kYes = 0, kNo = 1, kBadInput = 2, kInterrupted = 130 };

}  // namespace alignability::cli
