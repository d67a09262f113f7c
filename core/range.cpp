// SPDX-License-Identifier: BSD-3-Clause
#include "core/range.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace alignability {

bool Range::contains(double value) const {
  if (!std::isfinite(value)) return false;
  const bool above = min_end == End::open ? value > min : value >= min;
  const bool below = max_end == End::open ? value < max : value <= max;
  return above && below;
}

std::string Range::description() const {
  const bool bounded_below = min > std::numeric_limits<double>::lowest();
  const bool bounded_above = max < std::numeric_limits<double>::max();
  if (bounded_below && bounded_above && min_end == End::closed && max_end == End::closed) {
    return "from " + to_text(min) + " to " + to_text(max);
  }
  const std::string from = (min_end == End::open ? "greater than " : "at least ") + to_text(min);
  const std::string to = (max_end == End::open ? "less than " : "at most ") + to_text(max);
  if (bounded_below && bounded_above) return from + " and " + to;
  if (bounded_below) return from;
  if (bounded_above) return to;
  return "a finite number";
}

std::string to_text(double value) {
  std::array<char, 32> buffer;  // the longest takes 24
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> digits;
  const double magnitude = std::abs(value);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), magnitude, std::chars_format::fixed, decimals).ptr;
  const std::string text(digits.data(), end);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !zero ? "-" + text : text;
}

}  // namespace alignability
