// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/blend_along_arc.hpp"

#include <cmath>

namespace alignability {
namespace {

BilinearAlongArc difference(const BilinearAlongArc& high, const BilinearAlongArc& low) {
  BilinearAlongArc rise = low;
  rise.value = high.value - low.value;
  rise.gradient = high.gradient - low.gradient;
  rise.twist = high.twist - low.twist;
  return rise;
}

}  // namespace

BlendAlongArc::BlendAlongArc(const BilinearAlongArc& low, const BilinearAlongArc& high, double begin, double end)
    : length(low.length),
      low_(low),
      rise_(difference(high, low)),
      middle_share_(0.5 * (begin + end)),
      growth_(length > 0.0 ? (end - begin) / length : 0.0) {}

double BlendAlongArc::at(double s) const { return low_.at(s) + share(s) * rise_.at(s); }

double BlendAlongArc::slope(double s) const { return low_.slope(s) + share(s) * rise_.slope(s) + growth_ * rise_.at(s); }

double BlendAlongArc::steepest_bend() const {
  return low_.steepest_bend() + rise_.steepest_bend() + 2.0 * std::abs(growth_) * rise_.steepest_slope();
}

double BlendAlongArc::mean() const { return low_.mean() + middle_share_ * rise_.mean() + growth_ * rise_.mean_moment(); }

}  // namespace alignability
