// SPDX-License-Identifier: BSD-3-Clause
// Whether what takes long looks at whether to stop, and often; what the clock says is measured in docs/trust.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planner/alpha_floor.hpp"
#include "planner/drivable_area.hpp"
#include "planner/goal_field.hpp"
#include "planner/plan.hpp"
#include "planner/planners.hpp"
#include "planner/route_bounds.hpp"
#include "tests/planner/two_corridors.hpp"

namespace alignability {
namespace {

class TimeLimits : public testing::Test {
 protected:
  struct Stage {
    std::string name;
    std::function<void(const StopTest&)> run;
  };

  std::vector<Stage> stages() const {
    return {
        {"costs and shares", [this](const StopTest& stop) { CostLattice(*fields.risk, *fields.clearance, 5.0, 0.3, stop); }},
        {"a lattice with passages", [this](const StopTest& stop) { DrivableLattice(motion, stop); }},
        {"a field", [this](const StopTest& stop) { GoalField(lattice, goal, stop); }},
        {"a bound", [this](const StopTest& stop) { CostBound(costs, goal, 0.1, stop); }},
        {"the bounds of a route", [this](const StopTest& stop) { RouteBounds(area, 5.0, start, goal, 0.1, stop); }},
        {"the greatest floor", [this](const StopTest& stop) { greatest_alpha_floor(motion, start, goal, stop); }},
        {"whether there is a way", [this](const StopTest& stop) { area.may_connect(problem.query.start, problem.query.goal, 0.1, stop); }},
    };
  }

  PlanProblem problem = test::two_corridors();
  PlanningFields fields{problem};
  PlanarMotion motion{fields.risk, fields.clearance, 5.0, 0.3};
  DrivableArea area{fields.clearance, fields.risk, problem.query.robot};
  Eigen::Vector2d start = problem.query.start.position();
  Eigen::Vector2d goal = problem.query.goal.position();
  std::shared_ptr<const CostLattice> costs = std::make_shared<const CostLattice>(*fields.risk, *fields.clearance, 5.0, 0.3);
  std::shared_ptr<const DrivableLattice> lattice = std::make_shared<const DrivableLattice>(motion);
};

TEST_F(TimeLimits, EndEveryStageWheneverItAsks) {
  for (const Stage& stage : stages()) {
    SCOPED_TRACE(stage.name);
    std::atomic<int> asked = 0;
    stage.run([&] { return ++asked, false; });
    const int often = asked;
    EXPECT_GE(often, static_cast<int>(fields.clearance->geometry().size() / 8192));
    for (const int last : {1, (often + 1) / 2, often}) {
      asked = 0;
      EXPECT_THROW(stage.run([&] { return ++asked >= last; }), Interrupted) << "at question " << last;
    }
  }
}

TEST_F(TimeLimits, LeaveAPathThatIsRefinedAsGoodAsItIs) {
  const PlanarPath path = *steepest_path(motion, start, goal);
  const PlanarPath at_once = refined(path, motion, [] { return true; });
  const auto cost = [&](const PlanarPath& way) {
    double sum = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) sum += motion.cost(way[i - 1], way[i]);
    return sum;
  };
  EXPECT_LE(cost(at_once), cost(path));
  EXPECT_LT(cost(refined(path, motion)), cost(at_once));
  EXPECT_EQ(at_once.back(), path.back());
}

TEST_F(TimeLimits, OfNextToNothingEndInTimeoutWithEveryPlannerAndSpace) {
  for (const std::string& name : planner_names()) {
    for (const MotionSpace space : {MotionSpace::r2, MotionSpace::se2, MotionSpace::dubins, MotionSpace::reeds_shepp}) {
      if (refusal_of_planner(name, space)) continue;
      SCOPED_TRACE(name + " in " + to_string(space));
      PlanQuery query = problem.query;
      query.motion.space = space;
      query.motion.turning_radius = 1.0;
      query.planner = {.name = name, .time = 1e-9};
      const PlanResult result = plan(query, fields, {});
      EXPECT_EQ(result.status, PlanStatus::timeout);
      EXPECT_TRUE(result.path.empty());
    }
  }
}

TEST_F(TimeLimits, AreTakenByLimitsOfTheWayToo) {
  PlanQuery query = problem.query;
  query.weight = 0.0;
  query.max_blind_distance = 0.0;
  query.planner = {.name = "field", .time = 1e-9};
  EXPECT_EQ(plan(query, fields, {}).status, PlanStatus::timeout);
}

TEST_F(TimeLimits, DoNotConcernPlansOfSoManyIterations) {
  PlanQuery query = problem.query;
  query.planner = {.name = "field", .time = 1e-9, .iterations = 10};
  EXPECT_EQ(plan(query, fields, {}).status, PlanStatus::solved);
}

}  // namespace
}  // namespace alignability
