// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "alignability/explanation.hpp"
#include "core/pose.hpp"

namespace alignability {
namespace {

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

Eigen::Vector3d direction(double heading, double elevation) {
  const double along = std::cos(radians(elevation));
  return {along * std::cos(radians(heading)), along * std::sin(radians(heading)), std::sin(radians(elevation))};
}

ExplainedPlane plane(PlaneKind kind, const Eigen::Vector3d& normal, double share) {
  ExplainedPlane result;
  result.kind = kind;
  result.normal = normal;
  result.share = share;
  return result;
}

// With x, y, z for axes, in the order from the strongest that is given.
Explanation explanation(const Eigen::Vector3d& eigenvalues, const Eigen::Vector3d& strongest, const Eigen::Vector3d& weakest,
                        std::vector<ExplainedPlane> planes) {
  Explanation result;
  result.alignability.points = 1000;
  result.alignability.eigenvalues = eigenvalues;
  result.alignability.alpha = eigenvalues[2] / eigenvalues[0];
  result.alignability.planes_kept = static_cast<int>(planes.size());
  result.axes << strongest, weakest.cross(strongest), weakest;
  result.planes = std::move(planes);
  return result;
}

TEST(ExplanationText, NamesDirectionsByHeadingUnlessTheyAreUpOrDown) {
  EXPECT_EQ(direction_text(kZ), "up");
  EXPECT_EQ(direction_text(-kZ), "down");
  EXPECT_EQ(direction_text(direction(10.0, 61.0)), "up");
  EXPECT_EQ(direction_text(direction(10.0, -61.0)), "down");
  EXPECT_EQ(direction_text(direction(10.0, 29.0)), "10 deg");
  EXPECT_EQ(direction_text(direction(10.0, 45.0)), "10 deg, 45 deg up");
  EXPECT_EQ(direction_text(direction(-135.0, -45.0)), "-135 deg, 45 deg down");
  EXPECT_EQ(direction_text(kX), "0 deg");
  EXPECT_EQ(direction_text(-kX), "180 deg");
  EXPECT_EQ(direction_text({-1.0, -0.0, 0.0}), "180 deg");
  EXPECT_EQ(direction_text(-kY), "-90 deg");
  EXPECT_EQ(direction_text(direction(-0.2, 0.0)), "0 deg");
}

TEST(ExplanationText, JudgesAsTheRiskDoes) {
  const RiskOptions risk{.alpha_critical = 0.2, .alpha_safe = 0.6};
  EXPECT_EQ(verdict(0.0, risk), Verdict::blind);
  EXPECT_EQ(verdict(0.19, risk), Verdict::blind);
  EXPECT_EQ(verdict(0.2, risk), Verdict::poor);
  EXPECT_EQ(verdict(0.59, risk), Verdict::poor);
  EXPECT_EQ(verdict(0.6, risk), Verdict::safe);
  EXPECT_EQ(verdict(1.0, risk), Verdict::safe);
}

TEST(ExplanationText, SaysThatNothingFacesAlongACorridor) {
  Explanation corridor = explanation(
      {0.88, 0.1, 0.02}, kY, kX, {plane(PlaneKind::wall, kY, 0.5), plane(PlaneKind::wall, -kY, 0.37), plane(PlaneKind::floor, kZ, 0.13)});
  EXPECT_EQ(sentence(corridor, {}),
            "Blind, alpha 0.023: nothing faces along x: the normals are of walls (87.0 %, 2 planes) and floor (13.0 %, 1 plane).");
  corridor.noise = 0.987;
  EXPECT_EQ(
      sentence(corridor, {}),
      "Blind, alpha 0.023: nothing faces along x: the normals are of walls (87.0 %, 2 planes) and floor (13.0 %, 1 plane). Of what holds "
      "it there, 98.7 % is noise: normals that lean off their planes.");
}

TEST(ExplanationText, SaysWhatFacesTheWeakestDirection) {
  const Explanation room = explanation(
      {0.6, 0.25, 0.15}, kX, kY,
      {plane(PlaneKind::wall, -kX, 0.6), plane(PlaneKind::floor, kZ, 0.25), plane(PlaneKind::wall, direction(100.0, 0.0), 0.15)});
  EXPECT_EQ(
      sentence(room, {}),
      "Poor, alpha 0.250: the scan is held least along y. Of the normals, those of walls (15.0 %, 1 plane) face that way; those of walls "
      "(60.0 %, 1 plane) and floor (25.0 %, 1 plane) do not.");
  Explanation cluttered = room;
  cluttered.planes.push_back(plane(PlaneKind::slope, direction(0.0, 45.0), 0.004));
  EXPECT_EQ(sentence(cluttered, {}), sentence(room, {})) << "a few points on an edge are not worth a word";
  EXPECT_EQ(sentence(room, {.alpha_critical = 0.1, .alpha_safe = 0.2}).substr(0, 5), "Safe,");
}

TEST(ExplanationText, NamesTwoDirectionsThatAreEquallyWeakTogether) {
  const Explanation hall = explanation({0.84, 0.081, 0.079}, kZ, kX, {plane(PlaneKind::floor, kZ, 1.0)});
  EXPECT_EQ(sentence(hall, {}),
            "Blind, alpha 0.094: nothing faces in any horizontal direction: the normals are of floor (100.0 %, 1 plane).");
  const Explanation wall = explanation({1.0, 0.0, 0.0}, direction(61.0, 0.0), kZ, {plane(PlaneKind::wall, direction(61.0, 0.0), 1.0)});
  EXPECT_EQ(sentence(wall, {}),
            "Blind, alpha 0.000: nothing faces in any direction square to heading 61 deg: the normals are of walls (100.0 %, 1 plane).");
}

TEST(ExplanationText, NamesAWeakAxisWhicheverWayItPoints) {
  for (const double sign : {1.0, -1.0}) {
    const auto weak_along = [&](const Eigen::Vector3d& axis) {
      const std::string text = sentence(explanation({0.8, 0.15, 0.05}, kY, sign * axis, {plane(PlaneKind::wall, kY, 1.0)}), {});
      const std::string begin = "Blind, alpha 0.062: nothing faces along ";
      EXPECT_EQ(text.substr(0, begin.size()), begin);
      return text.substr(begin.size(), text.find(':', begin.size()) - begin.size());
    };
    EXPECT_EQ(weak_along(direction(4.0, 0.0)), "x");
    EXPECT_EQ(weak_along(direction(-4.0, 0.0)), "x");
    EXPECT_EQ(weak_along(direction(29.0, 10.0)), "heading 29 deg");
    EXPECT_EQ(weak_along(direction(-29.0, 0.0)), "heading 151 deg");
    EXPECT_EQ(weak_along(direction(-29.0, 40.0)), "heading -29 deg, 40 deg up");
    EXPECT_EQ(weak_along(direction(0.0, 80.0)), "the vertical");
  }
}

TEST(ExplanationText, SaysWhenThereIsNothingToExplain) {
  Explanation none;
  EXPECT_EQ(weakest_text(none), "");
  EXPECT_EQ(sentence(none, {}), "Blind, alpha 0.000: nothing came back.");
  none.alignability.points = 12;
  EXPECT_EQ(sentence(none, {}), "Blind, alpha 0.000: there is no plane among the 12 points.");
  none.alignability.dimensions = 2;
  EXPECT_EQ(sentence(none, {}), "Blind, alpha 0.000: there is no line among the 12 points.");
}

}  // namespace
}  // namespace alignability
