// SPDX-License-Identifier: BSD-3-Clause
#include "planner/nurbs.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/range.hpp"
#include "core/segment.hpp"

namespace alignability {
namespace {

constexpr int kHighestDegree = 32;
constexpr Range kWeights{.min = 1e-6, .max = 1e6};
constexpr Range kNumbers{.min = -1e9, .max = 1e9};

// A Bézier curve by its control points (weight·x, weight·y, weight). It lies in the convex hull of their projections.
using Bezier = std::vector<Eigen::Vector3d>;

Eigen::Vector2d projected(const Eigen::Vector3d& point) { return point.head<2>() / point.z(); }

// De Boor's algorithm for the span that begins at knot `span`, with an argument of its own for each step: `late` times the span's end,
// otherwise its beginning. That is the control point `late` of the span as a Bézier curve. All shares lie in [0,1].
Eigen::Vector3d control_point(const Nurbs& curve, std::size_t span, std::size_t late) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  Bezier points;
  for (std::size_t i = span - degree; i <= span; ++i) points.push_back(curve.points[i].weight * curve.points[i].at.homogeneous());
  for (std::size_t step = 1; step <= degree; ++step) {
    const double at = curve.knots[step <= late ? span + 1 : span];
    for (std::size_t j = degree; j >= step; --j) {
      const std::size_t i = span - degree + j;
      const double share = (at - curve.knots[i]) / (curve.knots[i + degree - step + 1] - curve.knots[i]);
      points[j] = (1.0 - share) * points[j - 1] + share * points[j];
    }
  }
  return points.back();
}

std::vector<Bezier> bezier_curves(const Nurbs& curve) {
  std::vector<Bezier> curves;
  for (auto span = static_cast<std::size_t>(curve.degree); span < curve.points.size(); ++span) {
    if (curve.knots[span] == curve.knots[span + 1]) continue;
    Bezier bezier;
    for (std::size_t late = 0; late <= static_cast<std::size_t>(curve.degree); ++late) {
      bezier.push_back(control_point(curve, span, late));
    }
    curves.push_back(std::move(bezier));
  }
  return curves;
}

bool is_flat(const Bezier& curve, double tolerance) {
  const Eigen::Vector2d from = projected(curve.front());
  const Eigen::Vector2d to = projected(curve.back());
  return std::ranges::all_of(curve,
                             [&](const Eigen::Vector3d& point) { return distance_to_segment(projected(point), from, to) <= tolerance; });
}

// De Casteljau's algorithm.
std::pair<Bezier, Bezier> halved(Bezier curve) {
  Bezier first;
  Bezier second;
  while (!curve.empty()) {
    first.push_back(curve.front());
    second.push_back(curve.back());
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) curve[i] = 0.5 * (curve[i] + curve[i + 1]);
    curve.pop_back();
  }
  std::ranges::reverse(second);
  return {std::move(first), std::move(second)};
}

// The pose at an end of a curve, `inwards` the control points from there on; nullopt when all of them lie in one place.
template <typename Iterator>
std::optional<Pose2> pose_at_end(Iterator inwards, Iterator end, double direction) {
  const Eigen::Vector2d at = projected(*inwards);
  for (; inwards != end; ++inwards) {
    const Eigen::Vector2d step = direction * (projected(*inwards) - at);
    if (step != Eigen::Vector2d::Zero()) return Pose2{at.x(), at.y(), std::atan2(step.y(), step.x())};
  }
  return std::nullopt;
}

void append(const Bezier& curve, double tolerance, std::vector<Pose2>& path) {
  if (!is_flat(curve, tolerance)) {
    const auto [first, second] = halved(curve);
    append(first, tolerance, path);
    append(second, tolerance, path);
    return;
  }
  const auto from = pose_at_end(curve.begin(), curve.end(), 1.0);
  const auto to = pose_at_end(curve.rbegin(), curve.rend(), -1.0);
  if (!from || !to) return;
  constexpr double kKink = 1e-6;  // [rad]
  if (path.empty() || std::abs(normalized_angle(from->yaw - path.back().yaw)) > kKink) path.push_back(*from);
  path.push_back(*to);
}

}  // namespace

std::optional<std::string> fault_of_nurbs(const Nurbs& curve) {
  if (curve.degree < 1 || curve.degree > kHighestDegree) return "its degree must be from 1 to " + std::to_string(kHighestDegree);
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t points = curve.points.size();
  const std::vector<double>& knots = curve.knots;
  if (points <= degree)
    return "a degree of " + std::to_string(degree) + " takes at least " + std::to_string(degree + 1) + " control points";
  if (knots.size() != points + degree + 1) {
    return std::to_string(points) + " control points of degree " + std::to_string(degree) + " take " + std::to_string(points + degree + 1) +
           " knots, not " + std::to_string(knots.size());
  }
  for (const Nurbs::ControlPoint& point : curve.points) {
    if (!kNumbers.contains(point.at.x()) || !kNumbers.contains(point.at.y())) {
      return "its control points' coordinates must be " + kNumbers.description();
    }
    if (!kWeights.contains(point.weight)) return "its weights must be " + kWeights.description();
  }
  if (!std::ranges::all_of(knots, [](double knot) { return kNumbers.contains(knot); }))
    return "its knots must be " + kNumbers.description();
  if (!std::ranges::is_sorted(knots)) return "no knot may be less than the one before";
  if (knots[degree] == knots[points]) return "its knots leave it no length";
  for (std::size_t i = degree + 1; i < points; ++i) {
    const bool inside = knots[i] > knots[degree] && knots[i] < knots[points];
    if (inside && knots[i] == knots[i + degree])
      return "a knot within it may be repeated no more than " + std::to_string(degree) + " times";
  }
  return std::nullopt;
}

std::vector<Pose2> flattened(const Nurbs& curve, double tolerance) {
  std::vector<Pose2> path;
  for (const Bezier& bezier : bezier_curves(curve)) append(bezier, tolerance, path);
  return path;
}

}  // namespace alignability
