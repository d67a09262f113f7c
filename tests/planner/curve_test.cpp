// SPDX-License-Identifier: BSD-3-Clause
#include "planner/curve.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

#include <random>

#include "planner/alignability_objective.hpp"
#include "planner/drivability.hpp"
#include "planner/dubins_space.hpp"
#include "planner/path_figures.hpp"
#include "planner/poses.hpp"
#include "planner/steering.hpp"
#include "tests/planner/collision_oracle.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/random_sites.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

constexpr double kSide = 12.0;

template <typename Space>
ob::StateSpacePtr car_space(double radius) {
  const auto space = std::make_shared<Space>(radius);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(kSide);
  space->setBounds(bounds);
  return space;
}

struct Kind {
  const char* name;
  ob::StateSpacePtr (*make)(double radius);
};

constexpr Kind kKinds[] = {{"dubins", car_space<DubinsSpace>}, {"reeds_shepp", car_space<ob::ReedsSheppStateSpace>}};

double far_from(const Pose2& a, const Pose2& b) {
  return std::max((a.position() - b.position()).norm(), std::abs(normalized_angle(a.yaw - b.yaw)));
}

// Anywhere; also near one another, straight ahead, straight behind, in place: where words meet.
std::pair<Pose2, Pose2> pair_of_poses(std::mt19937_64& random) {
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const Pose2 from{draw(0.0, kSide), draw(0.0, kSide), draw(-3.1, 3.1)};
  switch (std::uniform_int_distribution<int>(0, 5)(random)) {
    case 0:
      return {from, {from.x + draw(-0.3, 0.3), from.y + draw(-0.3, 0.3), normalized_angle(from.yaw + draw(-0.3, 0.3))}};
    case 1:
      return {from, Arc{from, 0.0, draw(-4.0, 4.0)}.end()};
    case 2:
      return {from, from};
    case 3:
      return {from, Arc{from, draw(-1.0, 1.0), draw(-3.0, 3.0)}.end()};
    default:
      return {from, {draw(0.0, kSide), draw(0.0, kSide), draw(-3.1, 3.1)}};
  }
}

class CurvesOf : public testing::TestWithParam<Kind> {};

TEST_P(CurvesOf, AreWhatOmplInterpolates) {
  constexpr std::uint64_t kSeed = 21;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (const double radius : {0.3, 1.0, 1.5, 40.0}) {
    const ob::StateSpacePtr space = GetParam().make(radius);
    const Steering steering(space);
    EXPECT_NEAR(steering.turning_radius(), radius, 1e-12 * radius);
    const StateProjection projection = projection_of(space);
    ob::ScopedState<> a(space), b(space), at(space);
    for (int i = 0; i < 2000; ++i) {
      const auto [from, to] = pair_of_poses(random);
      set_pose(*space, from, a.get());
      set_pose(*space, to, b.get());
      const Curve curve = steering.word(projection(a.get()), projection(b.get()));
      if (GetParam().name == std::string("reeds_shepp")) {
        EXPECT_NEAR(curve.length(), space->distance(a.get(), b.get()), 1e-9 * (1.0 + curve.length()));
      }
      EXPECT_LE(curve.arcs().size(), Curve::kMostArcs);
      for (const double share : {0.1, 0.31, 0.5, 0.77, 0.999}) {
        space->interpolate(a.get(), b.get(), share, at.get());
        EXPECT_LT(far_from(curve.at(share * curve.length()), projection(at.get())), 1e-9 * (1.0 + radius));
      }
    }
  }
}

TEST_P(CurvesOf, EndWhereTheyShouldOrAreNone) {
  std::mt19937_64 random(22);
  const Steering steering(GetParam().make(1.5));
  int none = 0;
  constexpr int kTries = 20'000;
  for (int i = 0; i < kTries; ++i) {
    const auto [from, to] = pair_of_poses(random);
    const auto curve = steering(from, to);
    if (!curve) {
      ++none;
      continue;
    }
    EXPECT_LT(far_from(curve->end(), to), 2e-6);
    EXPECT_GE(curve->length(), (to.position() - from.position()).norm() - 1e-6);
    EXPECT_GE(curve->turned(), std::abs(normalized_angle(to.yaw - from.yaw)) - 1e-6);
    EXPECT_TRUE(steering.may_reverse() || curve->backward_length() == 0.0);
    const double s = 0.4 * curve->length();
    EXPECT_LT(far_from(curve->until(s).end(), curve->at(s)), 1e-9);
  }
  EXPECT_LT(none, kTries / 1000);
  RecordProperty("none", none);
}

TEST_P(CurvesOf, HavePosesAsDenseAsTheSagittaAsks) {
  std::mt19937_64 random(23);
  const Steering steering(GetParam().make(1.5));
  constexpr double kSagitta = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const auto [from, to] = pair_of_poses(random);
    const Curve curve = steering.word(from, to);
    const std::vector<Pose2> poses = poses_along(std::array{curve}, kSagitta);
    EXPECT_LT(far_from(poses.front(), from), 1e-12);
    EXPECT_LT(far_from(poses.back(), curve.end()), 1e-12);
    for (int k = 0; k <= 500; ++k) {
      const Eigen::Vector2d at = curve.at(curve.length() * k / 500.0).position();
      double nearest = (at - poses.front().position()).norm();
      for (std::size_t p = 1; p < poses.size(); ++p) {
        const Eigen::Vector2d step = poses[p].position() - poses[p - 1].position();
        const double share = std::clamp((at - poses[p - 1].position()).dot(step) / step.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (at - poses[p - 1].position() - share * step).norm());
      }
      EXPECT_LE(nearest, kSagitta * (1.0 + 1e-6));
    }
  }
}

TEST_P(CurvesOf, CostWhatASumOverSmallStepsSays) {
  std::mt19937_64 random(24);
  const PlanProblem site = test::random_site(3);
  const auto risk = std::make_shared<const RiskField>(site.alignability, site.occupancy, RiskOptions{});
  const auto space = GetParam().make(0.8);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  const ObjectiveOptions options{.weight = 3.0, .turn_cost = 0.25, .reverse_penalty = 0.5};
  const AlignabilityObjective objective(si, risk, options);
  EXPECT_FALSE(objective.isSymmetric());
  ob::ScopedState<> a(space), b(space), at(space);
  const StateProjection projection = projection_of(space);
  for (int i = 0; i < 30; ++i) {
    const auto [from, to] = pair_of_poses(random);
    set_pose(*space, from, a.get());
    set_pose(*space, to, b.get());
    constexpr int kSteps = 20'000;
    Pose2 last = from;
    double sum = 0.0;
    for (int k = 1; k <= kSteps; ++k) {
      space->interpolate(a.get(), b.get(), static_cast<double>(k) / kSteps, at.get());
      const Pose2 next = projection(at.get());
      const Eigen::Vector2d step = next.position() - last.position();
      const double yaw = last.yaw + 0.5 * normalized_angle(next.yaw - last.yaw);
      const bool backward = step.dot(Eigen::Vector2d(std::cos(yaw), std::sin(yaw))) < 0.0;
      const double here = risk->risk(0.5 * (last.x + next.x), 0.5 * (last.y + next.y), 0.0);
      sum += step.norm() * (1.0 + options.weight * here + (backward ? options.reverse_penalty : 0.0));
      sum += options.turn_cost * std::abs(normalized_angle(next.yaw - last.yaw));
      last = next;
    }
    const double cost = objective.motionCost(a.get(), b.get()).value();
    // A step in which the curve bends or turns back is as long as a 20,000th of it.
    EXPECT_NEAR(cost, sum, 1e-3 * cost + 1e-5);
    EXPECT_LE(objective.motionCostHeuristic(a.get(), b.get()).value(), cost + 1e-9);
  }
}

TEST_P(CurvesOf, CostTheSumOfTheirPartsToABillionth) {
  std::mt19937_64 random(25);
  const PlanProblem site = test::random_site(5);
  const RiskField risk(site.alignability, site.occupancy, RiskOptions{});
  const Steering steering(GetParam().make(0.8));
  for (int i = 0; i < 200; ++i) {
    const auto [from, to] = pair_of_poses(random);
    const Curve curve = steering.word(from, to);
    const PathFigures whole = measure(std::array{curve}, risk);
    // The same by a midpoint sum, between all places where the field may bend.
    double sum = 0.0;
    for (const Arc& arc : curve.arcs()) {
      constexpr int kSteps = 2000;
      for (int k = 0; k < kSteps; ++k) {
        const Pose2 at = arc.at(arc.length() * (k + 0.5) / kSteps);
        sum += arc.length() / kSteps * risk.risk(at.x, at.y, at.yaw);
      }
    }
    EXPECT_NEAR(whole.risk_integral, sum, 1e-5 * (1.0 + curve.length()));
    EXPECT_NEAR(whole.length, curve.length(), 1e-12 * (1.0 + curve.length()));
    EXPECT_LE(whole.longest_blind, whole.blind_length + 1e-12);
    EXPECT_LE(whole.blind_length, whole.length + 1e-9);
    const Curve first = curve.until(0.37 * curve.length());
    double parts = measure(std::array{first}, risk).risk_integral;
    for (double done = first.length(); const Arc& arc : curve.arcs()) {
      const double from_here = std::clamp(done, 0.0, arc.length());
      if (from_here < arc.length()) parts += risk.integral(arc.piece(from_here, arc.length()));
      done -= arc.length();
    }
    EXPECT_NEAR(parts, whole.risk_integral, 1e-9 * (1.0 + whole.risk_integral));
  }
}

const Robot kTruck{.radius = 0.0, .footprint = {{0.5, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.5, -0.2}}};
const Robot kHook{.radius = 0.0,
                  .footprint = {{0.4, 0.25}, {-0.2, 0.25}, {-0.2, -0.25}, {0.4, -0.25}, {0.4, -0.1}, {0.0, -0.1}, {0.0, 0.1}, {0.4, 0.1}}};

TEST_P(CurvesOf, AreValidOnlyWhereTheRobotNeverCollidesAndInvalidOnlyWhereItAllButDoes) {
  int valid = 0;
  int invalid = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PlanProblem site = test::random_site(seed);
    const GridGeometry& grid = site.occupancy.geometry();
    const auto clearance = std::make_shared<const ClearanceMap>(site.occupancy);
    const auto risk = std::make_shared<const RiskField>(site.alignability, site.occupancy, RiskOptions{});
    const Steering steering(GetParam().make(0.6));
    for (const Robot& robot : {site.query.robot, kTruck, kHook}) {
      const DrivableArea area(clearance, risk, robot);
      for (int i = 0; i < 30 / test::kOneOf; ++i) {
        const auto place = [&]() -> Pose2 {
          const Eigen::Vector2d at = grid.origin + grid.extent().cwiseProduct(Eigen::Vector2d(std::uniform_real_distribution<>()(random),
                                                                                              std::uniform_real_distribution<>()(random)));
          return {at.x(), at.y(), std::uniform_real_distribution<>(-3.1, 3.1)(random)};
        };
        const Pose2 from = place();
        Pose2 to = place();
        to = {from.x + 0.3 * (to.x - from.x), from.y + 0.3 * (to.y - from.y), to.yaw};
        const auto curve = steering(from, to);
        if (!curve) continue;
        // So dense that chords lie within a micrometre of the curve, which the oracle forgives.
        const bool hit = test::first_collision(site.occupancy, robot, poses_along(std::array{*curve}, 2e-7)).has_value();
        const bool is_valid = area.contains(*curve);
        EXPECT_FALSE(is_valid && hit);
        ++(is_valid ? valid : invalid);
        if (is_valid || hit) continue;
        // Refused without a hit every centimetre: then a slightly larger robot hits.
        Robot larger = robot;
        larger.radius += 0.012;
        for (Eigen::Vector2d& corner : larger.footprint) corner *= 1.08;
        EXPECT_TRUE(test::first_collision(site.occupancy, larger, poses_along(std::array{*curve}, 2e-7)).has_value());
      }
    }
  }
  EXPECT_GT(valid, 50 / test::kOneOf);
  EXPECT_GT(invalid, 50 / test::kOneOf);
}

TEST_P(CurvesOf, AreValidUpToTheirLastValidState) {
  const PlanProblem site = test::random_site(4);
  const auto clearance = std::make_shared<const ClearanceMap>(site.occupancy);
  const auto risk = std::make_shared<const RiskField>(site.alignability, site.occupancy, RiskOptions{});
  const DrivableArea area(clearance, risk, site.query.robot);
  const auto space = GetParam().make(0.6);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-10.0);
  bounds.setHigh(20.0);
  space->as<ob::SE2StateSpace>()->setBounds(bounds);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
  si->setMotionValidator(motion_validator_for(si, area));
  si->setup();
  ob::ScopedState<> a(space), b(space), last(space);
  set_pose(*space, site.query.start, a.get());
  int tried = 0;
  for (int i = 0; i < 500 && tried < 20; ++i) {
    b.random();
    std::pair<ob::State*, double> valid{last.get(), -1.0};
    if (si->checkMotion(a.get(), b.get(), valid)) continue;
    ++tried;
    EXPECT_GE(valid.second, 0.0);
    EXPECT_LT(valid.second, 1.0);
    EXPECT_TRUE(si->isValid(last.get()));
  }
  EXPECT_EQ(tried, 20);
}

INSTANTIATE_TEST_SUITE_P(Spaces, CurvesOf, testing::ValuesIn(kKinds), [](const auto& kind) { return std::string(kind.param.name); });

// In OMPL's own space an interpolation may end the program: few of them, and none with a long straight after hardly a turn.
TEST(DubinsSpace, HasOmplsCurves) {
  std::mt19937_64 random(31);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (const double radius : {0.5, 1.5, 6.0}) {
    const ob::StateSpacePtr theirs = car_space<ob::DubinsStateSpace>(radius);
    const ob::StateSpacePtr ours = car_space<DubinsSpace>(radius);
    ob::ScopedState<> a(theirs), b(theirs), at(theirs), at_too(ours);
    for (int i = 0; i < 2000; ++i) {
      set_pose(*theirs, {draw(0.0, kSide), draw(0.0, kSide), draw(-3.1, 3.1)}, a.get());
      set_pose(*theirs, {draw(0.0, kSide), draw(0.0, kSide), draw(-3.1, 3.1)}, b.get());
      EXPECT_NEAR(ours->distance(a.get(), b.get()), theirs->distance(a.get(), b.get()), 1e-9 * kSide);
      for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        theirs->interpolate(a.get(), b.get(), share, at.get());
        ours->interpolate(a.get(), b.get(), share, at_too.get());
        EXPECT_LT(far_from(projection_of(theirs)(at.get()), projection_of(ours)(at_too.get())), 1e-9 * kSide);
      }
    }
  }
}

TEST(DubinsSpace, SurvivesTurnsThatOmplRoundsAway) {
  for (const double off : {-4e-7, -2e-7, -1e-8, -1e-10, -1e-15, 0.0, 1e-15, 1e-10, 4e-7}) {
    for (const double yaw : {0.0, 0.3, -2.0}) {
      const Pose2 from{1.0, 2.0, yaw + off};
      const Pose2 to{1.0 + 9.0 * std::cos(yaw), 2.0 + 9.0 * std::sin(yaw), yaw + 0.5 * off};
      const Curve curve = shortest_dubins_curve(from, to, 0.5);
      EXPECT_LT(far_from(curve.end(), to), 1e-7);
      EXPECT_LT(curve.length(), 9.0 + 1e-6);
    }
  }
}

TEST(DubinsSpace, DrivesASingleArcAsOne) {
  std::mt19937_64 random(33);
  for (int i = 0; i < 2000; ++i) {
    const double radius = 0.7;
    const double length = std::uniform_real_distribution<double>(0.0, 3.0 * radius)(random);
    const Pose2 from{40.0 + i * 0.01, 30.0, 0.003 * i - 3.0};
    const Arc arc{from, (i % 2 == 0 ? 1.0 : -1.0) / radius, length};
    EXPECT_NEAR(shortest_dubins_curve(from, arc.end(), radius).length(), length, 1e-7);
  }
}

TEST(Steering, IsOfOneWayCarsAlone) {
  EXPECT_THROW(Steering(std::make_shared<ob::RealVectorStateSpace>(2)), ompl::Exception);
  EXPECT_THROW(Steering(std::make_shared<ob::SE2StateSpace>()), ompl::Exception);
  EXPECT_THROW(Steering(std::make_shared<ob::DubinsStateSpace>(1.0, true)), ompl::Exception);
  EXPECT_FALSE(Steering(std::make_shared<ob::DubinsStateSpace>(1.0)).may_reverse());
  EXPECT_TRUE(Steering(std::make_shared<ob::ReedsSheppStateSpace>(1.0)).may_reverse());
}

}  // namespace
}  // namespace alignability
