// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace alignability::detail {

struct ChildLimits {
  std::chrono::milliseconds time{};
  std::uintmax_t memory = 0;  ///< beyond what this process has mapped already [bytes]; without effect under a sanitizer
};

/// What came of work in a child.
struct ChildOutcome {
  std::string bytes;  ///< what the work returned, where nothing went wrong
  std::string fault;  ///< "crashed", "took more than 20 s": completes "the importer …"; empty where nothing went wrong
};

/// Does work in a child of this process, whose end is not ours: for libraries that crash, hang or fill memory on damaged input. The child
/// is a copy made by fork, with the calling thread alone, so the work must not wait for others; it prints nothing, ends with its parent,
/// and takes no notice of an interrupt, which is the parent's. Throws std::system_error when there can be no child.
ChildOutcome in_child_process(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace alignability::detail
