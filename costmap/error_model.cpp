// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/error_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/range.hpp"

namespace alignability {

double ErrorModel::poverty(double alpha) const {
  if (std::isnan(alpha)) return 1.0;
  return std::clamp((alpha_rich - alpha) / (alpha_rich - alpha_poor), 0.0, 1.0);
}

ErrorModel::Change ErrorModel::change(double alpha, double metres) const {
  const double poor = poverty(alpha);
  const double rate = (1.0 - poor) / recovery;
  const double decay = std::exp(-rate * metres);
  // ∫ of what is left of a unit of growth, over the metres.
  const double growing = rate > 0.0 ? -std::expm1(-rate * metres) / rate : metres;
  return {least * (1.0 - decay) + growth * poor * growing, decay};
}

double ErrorModel::advanced(double error, double alpha, double metres) const { return std::max(least, change(alpha, metres).of(error)); }

std::vector<std::string> mismatches(const Calibration& fitted, const Calibration& used) {
  std::vector<std::string> sentences;
  const auto compare = [&](const char* what, const std::string& then, const std::string& now) {
    if (then != now) sentences.push_back(std::string("fitted for ") + what + ' ' + then + ", used for " + now);
  };
  const auto range = [](const std::optional<double>& metres) { return metres ? to_text(*metres) + " m" : "in full"; };
  compare("localizer", fitted.localizer, used.localizer);
  compare("sensor", fitted.sensor, used.sensor);
  compare("range noise", to_text(fitted.noise) + " m", to_text(used.noise) + " m");
  compare("range", range(fitted.range_max), range(used.range_max));
  compare("an odometry bias of", to_text(fitted.scale_bias), to_text(used.scale_bias));
  return sentences;
}

}  // namespace alignability
