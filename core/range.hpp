// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

namespace alignability {

/// The finite numbers from `min` to `max`; an end that is open does not belong to it. NaN and the infinities never do.
struct Range {
  enum class End { closed, open };

  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
  End min_end = End::closed;
  End max_end = End::closed;

  bool contains(double value) const;
  /// "greater than 0", "from 0 to 1", "a finite number": completes the sentence "must be …".
  std::string description() const;
};

inline constexpr Range kFinite{};
inline constexpr Range kPositive{.min = 0.0, .min_end = Range::End::open};
inline constexpr Range kNotNegative{.min = 0.0};
inline constexpr Range kShare{.min = 0.0, .max = 1.0};
/// What a weight in a sum of costs may be: with more, the metres beside it are lost to rounding.
inline constexpr Range kCostWeights{.min = 0.0, .max = 1e9};

/// The shortest decimal text that reads back as the same double: 0.1, 2500, 1e-09; nan, inf.
std::string to_text(double value);

/// A finite number with that many digits after the point, whatever the locale, and no negative zero.
std::string fixed_text(double value, int decimals);

}  // namespace alignability
