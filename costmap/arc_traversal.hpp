// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arc.hpp"
#include "costmap/grid.hpp"
#include "costmap/traversal.hpp"

namespace alignability::detail {

/// A circle run through, the angle of the point on it growing or falling: `from`, then by `turn` [rad].
struct CircleRun {
  Eigen::Vector2d center;
  double radius;
  double from;
  double turn;

  double angle(double share) const { return from + share * turn; }
  Eigen::Vector2d at(double share) const { return center + radius * Eigen::Vector2d(std::cos(angle(share)), std::sin(angle(share))); }
};

/// Of an arc that is not straight.
inline CircleRun circle_run(const Arc& arc) {
  const double radius = 1.0 / arc.curvature;
  const Eigen::Vector2d left(-std::sin(arc.start.yaw), std::cos(arc.start.yaw));
  const double from = arc.start.yaw - std::copysign(0.5 * std::numbers::pi, arc.curvature);
  return {arc.start.position() + radius * left, std::abs(radius), from, arc.turn()};
}

// The crossings with the grid lines of one axis within a quarter of a circle in which the coordinate only grows or only falls: as
// LineCrossings, from the indices of the lines.
class QuarterCrossings {
 public:
  // `phase`: what to take off the circle's angle for the coordinate to be center + radius·cos.
  QuarterCrossings(double center, const CircleRun& run, double phase, double begin, double end, int cells)
      : center_(center), run_(run), phase_(phase), end_(end), middle_(run.angle(0.5 * (begin + end)) - phase) {
    const double from = center + run.radius * std::cos(run.angle(begin) - phase);
    // d cos = -sin.
    step_ = std::sin(middle_) * run.turn > 0.0 ? -1.0 : 1.0;
    if (step_ > 0.0) {
      next_ = std::max(0.0, std::floor(from) + 1.0);
      last_ = cells;
    } else {
      next_ = std::min(static_cast<double>(cells), std::ceil(from) - 1.0);
      last_ = 0.0;
    }
    meet();
  }

  double share() const { return share_; }
  void advance() {
    next_ += step_;
    meet();
  }

 private:
  void meet() {
    share_ = end_;
    const double cosine = (next_ - center_) / run_.radius;
    if ((last_ - next_) * step_ < 0.0 || std::abs(cosine) > 1.0) return;
    // The quarter lies on one side of the axis: of the two angles with that cosine the one on its side.
    const double near = normalized_angle(middle_);
    const double met = middle_ - near + std::copysign(std::acos(cosine), near);
    share_ = std::min(end_, (met + phase_ - run_.from) / run_.turn);
  }

  double center_;
  const CircleRun& run_;
  double phase_;
  double end_;
  double middle_;
  double step_;
  double next_;
  double last_;
  double share_ = 1.0;
};

/// As for segments, for a circle in units of cells, the shares those of its turn.
template <typename Visitor>
void traverse_unit_cells(const CircleRun& run, int width, int height, Visitor&& visit) {
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  const auto index = [](double at, int cells) { return at >= 0.0 ? static_cast<int>(std::min(at, static_cast<double>(cells))) : -1; };
  double quarter = run.turn > 0.0 ? std::floor(run.from / kQuarter) + 1.0 : std::ceil(run.from / kQuarter) - 1.0;
  for (double done = 0.0; done < 1.0; quarter += std::copysign(1.0, run.turn)) {
    const double end = std::min(1.0, (quarter * kQuarter - run.from) / run.turn);
    if (end <= done) continue;
    QuarterCrossings columns(run.center.x(), run, 0.0, done, end, width);
    QuarterCrossings rows(run.center.y(), run, kQuarter, done, end, height);
    while (done < end) {
      const double column_share = columns.share();
      const double row_share = rows.share();
      const double next = std::max(done, std::min(column_share, row_share));
      if (next > done) {
        const Eigen::Vector2d middle = run.at(0.5 * (done + next));
        visit(Cell{index(middle.x(), width), index(middle.y(), height)}, done, next);
      }
      if (column_share <= next) columns.advance();
      if (row_share <= next) rows.advance();
      done = next;
    }
  }
}

/// Calls `visit(cell, from_share, to_share)` for each piece of the arc that lies in one cell of a grid, in order, as for segments.
template <typename Visitor>
void traverse(const GridGeometry& geometry, const Arc& arc, Visitor&& visit) {
  if (arc.turn() == 0.0) {
    traverse(geometry, arc.start.position(), arc.end().position(), visit);
    return;
  }
  CircleRun run = circle_run(arc);
  run.center = (run.center - geometry.origin) / geometry.resolution;
  run.radius /= geometry.resolution;
  traverse_unit_cells(run, geometry.width, geometry.height, visit);
}

}  // namespace alignability::detail
