// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "costmap/clearance_map.hpp"

namespace alignability {
namespace {

// Of an arc that turns by at most a quarter.
bool fits(const ClearanceMap& map, const Arc& arc, double radius) {
  // A chord's disk that does not fit may miss the arc's by two bulges.
  constexpr double kFinest = 0.5e-3;  // [cells]
  const double bulge = arc.bulge();
  if (map.is_clear(arc.start.position(), arc.end().position(), radius + bulge)) return true;
  if (bulge <= kFinest * map.geometry().resolution) return false;
  const double middle = 0.5 * arc.length();
  if (!map.is_clear(arc.at(middle).position(), radius)) return false;
  return fits(map, arc.piece(0.0, middle), radius) && fits(map, arc.piece(middle, arc.length()), radius);
}

}  // namespace

bool ClearanceMap::is_clear(const Arc& arc, double radius) const {
  if (arc.curvature == 0.0) return is_clear(arc.start.position(), arc.end().position(), radius);
  if (!is_clear(arc.start.position(), radius) || !is_clear(arc.end().position(), radius)) return false;
  const double quarters = std::max(1.0, std::ceil(std::abs(arc.turn()) / (0.5 * std::numbers::pi)));
  for (double quarter = 0.0; quarter < quarters; ++quarter) {
    if (!fits(*this, arc.piece(arc.length() * quarter / quarters, arc.length() * (quarter + 1.0) / quarters), radius)) return false;
  }
  return true;
}

}  // namespace alignability
