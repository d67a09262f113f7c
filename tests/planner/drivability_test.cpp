// SPDX-License-Identifier: BSD-3-Clause
#include "planner/drivability.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <random>

#include "planner/poses.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;

class Drivability : public testing::Test {
 protected:
  Drivability() {
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(0, 20.0);
    bounds.setHigh(1, 10.0);
    const auto space = std::make_shared<ob::SE2StateSpace>();
    space->setBounds(bounds);
    si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker(std::make_shared<DrivabilityChecker>(si, area));
    si->setMotionValidator(std::make_shared<DrivabilityMotionValidator>(si, area));
    si->setup();
  }

  ob::ScopedState<> state(const Pose2& pose) const {
    ob::ScopedState<> made(si);
    set_pose(*si->getStateSpace(), pose, made.get());
    return made;
  }

  PlanProblem problem = test::two_corridors();
  DrivableArea area{std::make_shared<const ClearanceMap>(problem.occupancy),
                    std::make_shared<const RiskField>(problem.alignability, problem.occupancy, RiskOptions{}), problem.query.robot};
  ob::SpaceInformationPtr si;
};

TEST_F(Drivability, ADiskFitsUpToItsRadiusFromAWall) {
  // The block's upper side is at y = 7.5, the robot's radius 0.4.
  EXPECT_TRUE(si->isValid(state({10.0, 7.9 + 1e-9, 0.0}).get()));
  EXPECT_FALSE(si->isValid(state({10.0, 7.9 - 1e-9, 0.0}).get()));
  EXPECT_NEAR(si->getStateValidityChecker()->clearance(state({10.0, 8.4, 0.0}).get()), 0.5, 1e-9);
  EXPECT_LT(si->getStateValidityChecker()->clearance(state({10.0, 5.0, 0.0}).get()), 0.0);
}

TEST_F(Drivability, NoMotionPassesThroughTheBlock) {
  EXPECT_TRUE(si->checkMotion(state({2.0, 8.5, 0.0}).get(), state({18.0, 8.5, 3.0}).get()));
  EXPECT_FALSE(si->checkMotion(state({2.0, 8.5, 0.0}).get(), state({10.0, 1.5, 0.0}).get()));
}

TEST_F(Drivability, FindsTheLastValidPlaceOfAMotion) {
  ob::ScopedState<> last(si);
  std::pair<ob::State*, double> last_valid{last.get(), -1.0};
  const auto from = state({2.0, 5.0, 0.0});
  const auto to = state({12.0, 5.0, 0.0});
  EXPECT_FALSE(si->getMotionValidator()->checkMotion(from.get(), to.get(), last_valid));
  // The block begins at x = 4.
  EXPECT_NEAR(last_valid.second, 0.16, 1e-8);
  EXPECT_NEAR(last->as<ob::SE2StateSpace::StateType>()->getX(), 3.6, 1e-7);
  EXPECT_TRUE(si->isValid(last.get()));
}

TEST_F(Drivability, AMotionIsValidOnlyIfEveryPlaceOnItIs) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> x(0.5, 19.5), y(0.5, 9.5);
  int valid = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose2 a{x(engine), y(engine), 0.0}, b{x(engine), y(engine), 0.0};
    const bool motion = area.contains(a, b);
    valid += motion ? 1 : 0;
    bool all = true;
    for (int k = 0; k <= 1000; ++k) {
      const double t = k / 1000.0;
      all = all && area.contains({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0});
    }
    EXPECT_TRUE(all || !motion) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
  }
  EXPECT_GT(valid, 100);
}

TEST_F(Drivability, ConnectionIsDeniedOnlyWithProof) {
  EXPECT_TRUE(area.may_connect({2.0, 8.5, 0.0}, {18.0, 8.5, 0.0}, 0.1));
  Grid<float> sealed(problem.occupancy.geometry(), 1.0f);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 200; ++column) {
      if (column < 90 || column > 91) sealed[Cell{column, row}] = problem.occupancy.occupancy({column, row}).value();
    }
  }
  const OccupancyMap occupancy(std::move(sealed));
  const DrivableArea divided(std::make_shared<const ClearanceMap>(occupancy),
                             std::make_shared<const RiskField>(problem.alignability, occupancy, RiskOptions{}), problem.query.robot);
  EXPECT_FALSE(divided.may_connect({2.0, 8.5, 0.0}, {18.0, 8.5, 0.0}, 0.1));
  EXPECT_TRUE(divided.may_connect({2.0, 8.5, 0.0}, {2.0, 1.5, 0.0}, 0.1));
}

}  // namespace
}  // namespace alignability
