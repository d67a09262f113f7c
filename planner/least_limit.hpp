// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "core/progress.hpp"

namespace alignability {

/// Where a limit is looked for that can be kept.
struct LimitRange {
  double least = 0.0;  ///< no smaller one can be
  double most = 0.0;   ///< a greater one will do no more
};

/// The smallest limit that does, to within 1 % or a thousandth, itself one that does; nullopt where none does. Throws Interrupted. What
/// does must do when greater.
std::optional<double> least_limit(const LimitRange& range, const std::function<bool(double)>& does, const StopTest& stop);

}  // namespace alignability
