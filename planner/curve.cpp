// SPDX-License-Identifier: BSD-3-Clause
#include "planner/curve.hpp"

#include <algorithm>

namespace alignability {
namespace {

using ChordTest = std::function<bool(const Pose2&, const Pose2&)>;

void append_chord(std::vector<Pose2>& poses, const Arc& arc, double finest, const ChordTest& is_drivable) {
  Pose2 end = arc.end();
  end.yaw = normalized_angle(end.yaw);
  if (arc.bulge() > finest && !is_drivable(poses.back(), end)) {
    const double middle = 0.5 * arc.length();
    append_chord(poses, arc.piece(0.0, middle), finest, is_drivable);
    append_chord(poses, arc.piece(middle, arc.length()), finest, is_drivable);
  } else {
    poses.push_back(end);
  }
}

void append_poses(std::vector<Pose2>& poses, const Arc& arc, double sagitta, const ChordTest& is_drivable) {
  // That of a chord which turns by φ is (1 - cos φ/2) / κ.
  const double widest = 4.0 * std::asin(std::sqrt(std::min(0.5, 0.5 * sagitta * std::abs(arc.curvature))));
  const int chords = arc.curvature == 0.0 ? 1 : std::max(1, static_cast<int>(std::ceil(std::abs(arc.turn()) / widest)));
  for (int chord = 0; chord < chords; ++chord) {
    const Arc piece = arc.piece(arc.length() * chord / chords, arc.length() * (chord + 1) / chords);
    append_chord(poses, piece, 1e-3 * sagitta, is_drivable);
  }
}

}  // namespace

void Curve::append(double curvature, double travel) {
  if (travel != 0.0) arcs_.at(count_) = {end(), curvature, travel}, ++count_;
}

Pose2 Curve::at(double s) const {
  for (const Arc& arc : arcs()) {
    if (s <= arc.length()) return arc.at(s);
    s -= arc.length();
  }
  return end();
}

Curve Curve::until(double s) const {
  Curve part(start_);
  for (const Arc& arc : arcs()) {
    part.append(arc.curvature, std::copysign(std::clamp(s, 0.0, arc.length()), arc.travel));
    s -= arc.length();
  }
  return part;
}

double Curve::length() const {
  double sum = 0.0;
  for (const Arc& arc : arcs()) sum += arc.length();
  return sum;
}

double Curve::backward_length() const {
  double sum = 0.0;
  for (const Arc& arc : arcs()) sum += std::max(0.0, -arc.travel);
  return sum;
}

double Curve::turned() const {
  double sum = 0.0;
  for (const Arc& arc : arcs()) sum += std::abs(arc.turn());
  return sum;
}

std::vector<Pose2> poses_along(std::span<const Curve> curves, double sagitta) {
  return poses_along(curves, sagitta, [](const Pose2&, const Pose2&) { return true; });
}

std::vector<Pose2> poses_along(std::span<const Curve> curves, double sagitta, const ChordTest& is_drivable) {
  std::vector<Pose2> poses;
  if (curves.empty()) return poses;
  poses.push_back(curves.front().start());
  poses.front().yaw = normalized_angle(poses.front().yaw);
  for (const Curve& curve : curves) {
    for (const Arc& arc : curve.arcs()) append_poses(poses, arc, sagitta, is_drivable);
  }
  return poses;
}

}  // namespace alignability
