// SPDX-License-Identifier: BSD-3-Clause
#include "cli/reading_text.hpp"

#include <cstdio>

#include "core/range.hpp"

namespace alignability::cli {

std::string reading_text(Reading reading, const Readings& readings) {
  if (reading != Reading::information) return fixed_text(value_of(reading, readings), 4);
  const PlanarInformation& information = readings.information;
  char text[100];
  std::snprintf(text, sizeof text, "%.3g /m2 along (%s, %s), %.3g /rad2", information.least,
                fixed_text(information.weakest_direction.x(), 2).c_str(), fixed_text(information.weakest_direction.y(), 2).c_str(),
                information.yaw);
  return text;
}

}  // namespace alignability::cli
