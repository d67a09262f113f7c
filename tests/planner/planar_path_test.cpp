// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planar_path.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "planner/goal_field.hpp"
#include "planner/plan.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/plane_site.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

using namespace test;

bool is_allowed(const PlanarPath& path, const PlanarMotion& motion) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!motion.is_allowed(path[i - 1], path[i])) return false;
  }
  return true;
}

// A wall of 2 m at x = 9 to 11, with a gap of 13 cells of 0.1 m around y = 5.05, the middle of cells.
bool wall_with_a_gap(const Eigen::Vector2d& at) { return std::abs(at.x() - 10.0) < 1.0 && std::abs(at.y() - 5.05) > 0.65; }

TEST(PlanarPath, PassesAGapThatIsTwoCentimetresWiderThanTheRobotAndHoldsNoCorner) {
  const PlaneSite site(square(0.1, 200), safe, wall_with_a_gap, 5.0, 0.64);
  const Eigen::Vector2d start(3.0, 5.05), goal(17.0, 5.05);
  const auto path = steepest_path(site.motion, start, goal);
  ASSERT_TRUE(path.has_value());
  EXPECT_TRUE(is_allowed(*path, site.motion));
  const PlanarPath straight = refined(*path, site.motion);
  EXPECT_TRUE(is_allowed(straight, site.motion));
  EXPECT_NEAR(cost_of(straight, site.motion), 14.0, 1e-3);
}

TEST(PlanarPath, PassesNoGapThatIsNarrowerThanTheRobot) {
  const PlaneSite site(square(0.1, 200), safe, wall_with_a_gap, 5.0, 0.651);
  EXPECT_FALSE(steepest_path(site.motion, {3.0, 5.05}, {17.0, 5.05}).has_value());
}

// Of stairs, at many angles.
TEST(PlanarPath, PassesSlantingGapsWithSixMillimetresToSpare) {
  int passed = 0;
  for (int degrees = 5; degrees < 180; degrees += 10) {
    SCOPED_TRACE(degrees);
    const Eigen::Vector2d middle(3.5, 3.5);
    const Eigen::Vector2d along(std::cos(radians(degrees)), std::sin(radians(degrees)));
    const auto wall = [&](const Eigen::Vector2d& at) {
      const Eigen::Vector2d from_middle = at - middle;
      return std::abs(from_middle.dot(along)) < 1.0 && std::abs(along.x() * from_middle.y() - along.y() * from_middle.x()) > 0.7;
    };
    const PlaneSite roomy(square(0.1, 70), safe, wall, 5.0, 0.1);
    const Eigen::Vector2d start = middle - 2.4 * along, goal = middle + 2.4 * along;
    // The largest radius with which a graph search on cells of 5 cm has a way, to a millimetre.
    PlanarMotion motion = roomy.motion;
    double fits = 0.5, not_any_more = 0.75;
    while (not_any_more - fits > 0.001) {
      motion.radius = 0.5 * (fits + not_any_more);
      (std::isfinite(least_cost_by_graph(motion, 2, start, goal)) ? fits : not_any_more) = motion.radius;
    }
    motion.radius = fits - 0.003;
    const auto path = steepest_path(motion, start, goal);
    EXPECT_TRUE(path.has_value());
    if (!path) continue;
    ++passed;
    EXPECT_TRUE(is_allowed(refined(*path, motion), motion));
  }
  EXPECT_EQ(passed, 18);
}

// Radii of whole and half cells have paths touch what they pass; others leave gaps of any width.
TEST(PlanarPath, IsFoundAndNearTheBestOfAFinerGraphSearch) {
  int searched = 0;
  for (std::uint64_t seed = 1; seed <= 200 / kOneOf; ++seed) {
    SCOPED_TRACE(seed);
    PlanProblem problem = random_site(seed);
    const double half_cell = 0.5 * problem.occupancy.geometry().resolution;
    if (seed % 2 == 0) problem.query.robot.radius = half_cell * std::floor(problem.query.robot.radius / half_cell);
    const PlanningFields fields(problem);
    const PlanarMotion motion{fields.risk, fields.clearance, problem.query.weight, problem.query.robot.radius};
    const Eigen::Vector2d start = problem.query.start.position(), goal = problem.query.goal.position();
    if ((start - goal).norm() < 1.0) continue;
    const double least = least_cost_by_graph(motion, 2, start, goal);
    const auto path = steepest_path(motion, start, goal);
    if (!std::isfinite(least)) continue;
    ++searched;
    ASSERT_TRUE(path.has_value());
    const PlanarPath fine = refined(*path, motion);
    EXPECT_TRUE(is_allowed(fine, motion));
    EXPECT_LE(cost_of(fine, motion), 1.06 * least);
  }
  EXPECT_GT(searched, 150 / kOneOf);
}

}  // namespace
}  // namespace alignability
