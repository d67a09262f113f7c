// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability::test {

/// How many times longer a planner gets for the same answer under a sanitizer.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double kPatience = 3.0;
#else
inline constexpr double kPatience = 1.0;
#endif

}  // namespace alignability::test
