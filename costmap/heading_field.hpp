// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/pose.hpp"
#include "costmap/bilinear_field.hpp"
#include "costmap/blend_along_arc.hpp"
#include "costmap/cubic.hpp"

namespace alignability {

/// A function of pose: bilinear in the plane at each of n headings, and between two neighbouring headings linear in yaw, all around.
/// Immutable; queries allocate nothing.
class HeadingField {
 public:
  /// Of no headings: not to be asked for a value.
  HeadingField() = default;
  /// The k-th is that at yaw 2πk/n. Throws std::invalid_argument unless there are at least two, on one grid.
  explicit HeadingField(std::vector<BilinearField> at_headings);

  bool empty() const { return at_headings_.empty(); }
  const std::vector<BilinearField>& at_headings() const { return at_headings_; }

  double at(const Pose2& pose) const;
  /// ∫ f ds [value · m] along the straight segment on which yaw turns evenly the shorter way around, in closed form; the same to the bit
  /// in either direction. O(patches crossed + headings turned through).
  double integral(const Pose2& from, const Pose2& to) const;
  /// Along an arc, its heading that of the arc, in closed form likewise: to 1e-9 of the greatest value times the length.
  double integral(const Arc& arc) const;

  /// Whether at every point of a segment there is some heading at which it is at least that much.
  bool reaches(double level, const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// Calls `visit(share, cubic)` for each piece of the segment that lies in one patch and between two headings, in order: see
  /// BilinearField.
  template <typename Visitor>
  void visit(const Pose2& from, const Pose2& to, Visitor&& visitor) const;
  /// Calls `visitor(const BlendAlongArc&)` likewise; an arc of no length has none.
  template <typename Visitor>
  void visit(const Arc& arc, Visitor&& visitor) const;

 private:
  double headings() const { return static_cast<double>(at_headings_.size()); }
  // In headings, from that at yaw 0 on.
  double position(double yaw) const { return yaw * headings() / (2.0 * std::numbers::pi); }
  const BilinearField& at_heading(double index) const {
    return at_headings_[static_cast<std::size_t>(index - headings() * std::floor(index / headings()))];
  }
  // Calls `visitor(low, high, begin, end, share_begin, share_end)` for each part of [begin, end] of a turn between two headings: of the
  // higher one's field the share at either end.
  template <typename Visitor>
  void visit_headings(double yaw, double turn, double begin, double end, Visitor&& visitor) const;

  std::vector<BilinearField> at_headings_;
};

template <typename Visitor>
void HeadingField::visit_headings(double yaw, double turn, double begin, double end, Visitor&& visitor) const {
  const double first = position(normalized_angle(yaw));
  const double turned = position(turn);
  const auto at = [&](double share) { return first + share * turned; };
  // Met in the order of the turn, each computed from its index.
  double line = turned > 0.0 ? std::floor(at(begin)) + 1.0 : std::ceil(at(begin)) - 1.0;
  for (double done = begin;;) {
    const double next = turned == 0.0 ? end : std::clamp((line - first) / turned, done, end);
    if (next > done) {
      const double low = std::floor(at(0.5 * (done + next)));
      const auto share_of_high = [&](double share) { return std::clamp(at(share) - low, 0.0, 1.0); };
      visitor(at_heading(low), at_heading(low + 1.0), done, next, share_of_high(done), share_of_high(next));
    }
    // Of what is no number there are no parts.
    if (!(next < end)) return;
    done = next;
    line += std::copysign(1.0, turned);
  }
}

template <typename Visitor>
void HeadingField::visit(const Pose2& from, const Pose2& to, Visitor&& visitor) const {
  const Eigen::Vector2d start = from.position();
  const Eigen::Vector2d step = to.position() - start;
  const double turn = normalized_angle(to.yaw - from.yaw);
  detail::traverse(at_headings_.front().patches(), start, to.position(), [&](Cell patch, double first, double last) {
    visit_headings(from.yaw, turn, first, last,
                   [&](const BilinearField& low, const BilinearField& high, double begin, double end, double share, double share_end) {
                     visitor(end - begin, Cubic::blend(low.along(start, step, patch, begin, end),
                                                       high.along(start, step, patch, begin, end), share, share_end));
                   });
  });
}

template <typename Visitor>
void HeadingField::visit(const Arc& arc, Visitor&& visitor) const {
  if (arc.travel == 0.0) return;
  detail::traverse(at_headings_.front().patches(), arc, [&](Cell patch, double first, double last) {
    visit_headings(arc.start.yaw, arc.turn(), first, last,
                   [&](const BilinearField& low, const BilinearField& high, double begin, double end, double share, double share_end) {
                     visitor(BlendAlongArc(low.along(arc, patch, begin, end), high.along(arc, patch, begin, end), share, share_end));
                   });
  });
}

}  // namespace alignability
