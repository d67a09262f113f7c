// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "alignability/explanation.hpp"
#include "core/pose.hpp"
#include "core/range.hpp"

namespace alignability {
namespace {

constexpr double kVertical = 60.0;        // elevation from which a direction is up or down [deg]
constexpr double kLevel = 30.0;           // elevation up to which it has but a heading [deg]
constexpr double kOnAxis = 5.0;           // how far a heading may be from that of x or y to go by its name [deg]
constexpr double kAlike = 1.2;            // λ_b/λ_c up to which two directions are equally weak
constexpr double kNothing = 1e-4;         // share of λ_a below which an eigenvalue is none
constexpr double kWorthMentioning = 0.1;  // share of λ_c
constexpr double kLeastGroup = 0.005;     // share of the normals that a kind is mentioned for beside a larger one

std::string percent(double share) { return fixed_text(100.0 * share, 1) + " %"; }

std::string whole_degrees(double angle) { return fixed_text(angle, 0) + " deg"; }

double elevation_of(const Eigen::Vector3d& unit) { return degrees(std::asin(std::clamp(unit.z(), -1.0, 1.0))); }

double heading_of(const Eigen::Vector3d& unit) { return degrees(std::atan2(unit.y(), unit.x())); }

// A direction whose sign means nothing: "x", "heading 61 deg" in [0, 180), "heading -98 deg, 39 deg up".
std::string axis_text(const Eigen::Vector3d& unit) {
  if (std::abs(elevation_of(unit)) >= kVertical) return "the vertical";
  if (std::abs(elevation_of(unit)) > kLevel) return "heading " + direction_text(unit.z() < 0.0 ? Eigen::Vector3d(-unit) : unit);
  const double heading = std::fmod(heading_of(unit) + 180.0, 180.0);
  if (heading <= kOnAxis || heading >= 180.0 - kOnAxis) return "x";
  return std::abs(heading - 90.0) <= kOnAxis ? "y" : "heading " + whole_degrees(heading);
}

// The directions in which a scan is held least, as many as are about equally weak: the last of the scan's dimensions in `axes`.
int weak_dimensions(const Alignability& result) {
  const double alike = kAlike * result.eigenvalues[result.dimensions - 1] + kNothing * result.eigenvalues[0];
  int weak = 1;
  while (weak < result.dimensions && result.eigenvalues[result.dimensions - 1 - weak] <= alike) ++weak;
  return weak;
}

struct Group {
  double share = 0.0;
  int planes = 0;
};

using Groups = std::map<PlaneKind, Group>;

// "walls (83.1 %, 9 planes) and floor (16.9 %, 58 planes)", the largest share first.
std::string groups_text(const Groups& groups) {
  constexpr const char* kNames[] = {"floor", "ceiling", "walls", "slopes"};
  std::vector<std::pair<PlaneKind, Group>> sorted(groups.begin(), groups.end());
  std::ranges::stable_sort(sorted, std::ranges::greater{}, [](const auto& entry) { return entry.second.share; });
  std::string text;
  while (sorted.size() > 1 && sorted.back().second.share < kLeastGroup) sorted.pop_back();
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto& [kind, group] = sorted[i];
    if (i > 0) text += i + 1 == sorted.size() ? " and " : ", ";
    text += std::string(kNames[static_cast<std::size_t>(kind)]) + " (" + percent(group.share) + ", " + std::to_string(group.planes) +
            (group.planes == 1 ? " plane)" : " planes)");
  }
  return text;
}

// Which planes' normals are less than 45° from where the scan is held least, and which are not.
struct Sides {
  Groups facing;
  Groups others;
};

Sides sides_of(const Explanation& explanation, int dimensions) {
  const int last = explanation.alignability.dimensions - 1;
  Sides sides;
  for (const ExplainedPlane& plane : explanation.planes) {
    double squares = 0.0;  // cos² of the angle to where it is held least
    for (int weak = 0; weak < dimensions; ++weak) {
      const double along = explanation.axes.col(last - weak).dot(plane.normal);
      squares += along * along;
    }
    const bool faces = squares > 0.5;
    Group& group = (faces ? sides.facing : sides.others)[plane.kind];
    group.share += plane.share;
    ++group.planes;
  }
  return sides;
}

std::string reason(const Explanation& explanation) {
  const int dimensions = weak_dimensions(explanation.alignability);
  const auto [facing, others] = sides_of(explanation, dimensions);
  const std::string place = weakest_text(explanation);
  if (dimensions == explanation.alignability.dimensions)
    return "the scan is held " + place + ": the normals are of " + groups_text(facing) + '.';
  if (facing.empty()) return "nothing faces " + place + ": the normals are of " + groups_text(others) + '.';
  const std::string rest = others.empty() ? "." : "; those of " + groups_text(others) + " do not.";
  return "the scan is held least " + place + ". Of the normals, those of " + groups_text(facing) + " face that way" + rest;
}

std::string capitalized(std::string text) {
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

Verdict verdict(double alpha, const RiskOptions& risk) {
  if (alpha < risk.alpha_critical) return Verdict::blind;
  return alpha < risk.alpha_safe ? Verdict::poor : Verdict::safe;
}

std::string_view to_string(PlaneKind kind) {
  constexpr std::string_view kNames[] = {"floor", "ceiling", "wall", "slope"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view to_string(Verdict verdict) {
  constexpr std::string_view kNames[] = {"blind", "poor", "safe"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string direction_text(const Eigen::Vector3d& unit) {
  const double elevation = elevation_of(unit);
  if (std::abs(elevation) >= kVertical) return elevation > 0.0 ? "up" : "down";
  const double heading = std::round(heading_of(unit));
  const std::string text = whole_degrees(heading == -180.0 ? 180.0 : heading);
  if (std::abs(elevation) <= kLevel) return text;
  return text + ", " + whole_degrees(std::abs(elevation)) + (elevation > 0.0 ? " up" : " down");
}

std::string weakest_text(const Explanation& explanation) {
  if (explanation.planes.empty()) return "";
  const int dimensions = weak_dimensions(explanation.alignability);
  if (dimensions == explanation.alignability.dimensions) return "in every direction alike";
  if (dimensions == 1) return "along " + axis_text(explanation.weakest_axis());
  const std::string strongest = axis_text(explanation.axes.col(0));
  return strongest == "the vertical" ? "in any horizontal direction" : "in any direction square to " + strongest;
}

std::string sentence(const Explanation& explanation, const RiskOptions& risk) {
  const Alignability& result = explanation.alignability;
  const std::string head =
      capitalized(std::string(to_string(verdict(result.alpha, risk)))) + ", alpha " + fixed_text(result.alpha, 3) + ": ";
  if (result.points == 0) return head + "nothing came back.";
  if (explanation.planes.empty())
    return head + (result.dimensions == 2 ? std::string("there is no line among the ") : std::string("there is no plane among the ")) +
           std::to_string(result.points) + " points.";

  std::string text = head + reason(explanation);
  if (result.alpha >= kNothing && explanation.noise >= kWorthMentioning) {
    text += " Of what holds it there, " + percent(explanation.noise) + " is noise: normals that lean off their planes.";
  }
  return text;
}

}  // namespace alignability
