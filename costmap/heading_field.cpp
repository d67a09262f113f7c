// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/heading_field.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace alignability {
namespace {

// Up to where from `begin` on, in [0,1], it is nowhere below the level; `begin` where it is below it at once.
double reach_of(const Quadratic& along, double level, double begin) {
  for (const double crossing : along.crossings(level)) {
    if (crossing <= begin) continue;
    if (along.at(0.5 * (begin + crossing)) < level) return begin;
    if (crossing < 1.0) return crossing;
  }
  return along.at(0.5 * (begin + 1.0)) < level ? begin : 1.0;
}

}  // namespace

HeadingField::HeadingField(std::vector<BilinearField> at_headings) : at_headings_(std::move(at_headings)) {
  if (at_headings_.size() < 2) throw std::invalid_argument("a field by heading needs at least two headings");
  const GridGeometry& grid = at_headings_.front().nodes().geometry();
  const auto is_other = [&](const BilinearField& field) { return field.nodes().geometry() != grid; };
  if (std::ranges::any_of(at_headings_, is_other)) throw std::invalid_argument("a field by heading needs one grid for all headings");
}

double HeadingField::at(const Pose2& pose) const {
  const double heading = position(pose.yaw);
  if (!std::isfinite(heading)) return std::numeric_limits<double>::quiet_NaN();
  const double low = std::floor(heading);
  const double here = at_heading(low).at(pose.position());
  return here + (heading - low) * (at_heading(low + 1.0).at(pose.position()) - here);
}

double HeadingField::integral(const Pose2& from, const Pose2& to) const {
  if (std::tie(to.x, to.y, to.yaw) < std::tie(from.x, from.y, from.yaw)) return integral(to, from);
  double mean = 0.0;
  visit(from, to, [&](double share, const Cubic& along) { mean += share * along.mean(); });
  return (to.position() - from.position()).norm() * mean;
}

double HeadingField::integral(const Arc& arc) const {
  double sum = 0.0;
  visit(arc, [&](const BlendAlongArc& piece) { sum += piece.length * piece.mean(); });
  return sum;
}

bool HeadingField::reaches(double level, const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  bool reached = true;
  const Eigen::Vector2d step = to - from;
  detail::traverse(at_headings_.front().patches(), from, to, [&](Cell patch, double begin, double end) {
    for (double done = 0.0; reached && done < 1.0;) {
      double farthest = done;
      for (const BilinearField& field : at_headings_) {
        const Quadratic along = field.along(from, step, patch, begin, end);
        if (along.is_number()) farthest = std::max(farthest, reach_of(along, level, done));
      }
      reached = farthest > done;
      done = farthest;
    }
  });
  return reached;
}

}  // namespace alignability
