// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace alignability {

enum class AxisScale {
  linear,
  logarithmic,  ///< what is not above 0 is drawn at the lower end
};

/// A value to mark by a line; its note reads "name value".
struct Threshold {
  double value = 0.0;
  std::string name;
};

/// What an axis of a chart shows. It spans all that is drawn along it, its thresholds as well, and where it is linear 0.
struct ChartAxis {
  std::string name;  ///< with its unit
  AxisScale scale = AxisScale::linear;
  std::vector<Threshold> thresholds = {};
};

}  // namespace alignability
