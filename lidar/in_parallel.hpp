// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace alignability {

/// Calls `work(i)` once for each i below `count`, in any order, on that many threads (0: one a processor), all of them in the caller's
/// floating-point mode, whoever woke them first. What a call throws ends the rest and is thrown.
void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace alignability
