// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "costmap/bilinear_along_arc.hpp"

namespace alignability {

/// From one bilinear function to another along the same piece of an arc, the latter's share going evenly from `begin` to `end`, both in
/// [0,1]. Arc lengths as of BilinearAlongArc.
class BlendAlongArc {
 public:
  BlendAlongArc(const BilinearAlongArc& low, const BilinearAlongArc& high, double begin, double end);

  double length;  ///< [m]

  /// False where a corner of the patch has no value.
  bool is_number() const { return low_.is_number() && rise_.is_number(); }
  double at(double s) const;
  double slope(double s) const;
  /// At least |d²/ds²| anywhere.
  double steepest_bend() const;
  /// In closed form, to some 1e-12.
  double mean() const;
  /// To 1e-11.
  double least() const { return detail::least_along(*this); }

  /// See BilinearAlongArc::visit_stretches.
  template <typename Visitor>
  void visit_stretches(double level, Visitor&& visit) const {
    detail::visit_stretches(*this, level, visit);
  }

 private:
  double share(double s) const { return middle_share_ + growth_ * s; }

  BilinearAlongArc low_;
  BilinearAlongArc rise_;  // what the other exceeds it by
  double middle_share_;
  double growth_;  // of the share [1/m]
};

}  // namespace alignability
