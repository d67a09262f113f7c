// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability::test {

/// How many times longer a planner gets for the same answer under a sanitizer, and of how many cases that are alike one is tried there:
/// without, all of them are.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double kPatience = 3.0;
inline constexpr int kOneOf = 5;
#else
inline constexpr double kPatience = 1.0;
inline constexpr int kOneOf = 1;
#endif

}  // namespace alignability::test
