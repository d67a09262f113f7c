// SPDX-License-Identifier: BSD-3-Clause
// A real map of 30 × 50 m at 3 cm, on which BIT* has been seen to find nothing under an objective with a heuristic but no cost-to-go.
#include <gtest/gtest.h>

#include <random>

#include "costmap/map_server.hpp"
#include "planner/plan.hpp"
#include "planner/planners.hpp"
#include "tests/planner/patience.hpp"
#include "tests/planner/random_sites.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

TEST(Nav2Warehouse, PlannersGetFromOneEndToTheOther) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(yaml, "maps/nav2/warehouse.yaml");
  PlanProblem problem{read_occupancy_map(yaml), {}, {}};
  problem.alignability = test::random_alignability(problem.occupancy.geometry(), 1);
  problem.query.robot.radius = 0.3;
  const ClearanceMap clearance(problem.occupancy);
  std::mt19937_64 engine(2);
  const auto place = [&](double low, double high) {
    const GridGeometry& map = problem.occupancy.geometry();
    std::uniform_real_distribution<double> x(map.origin.x(), map.upper_corner().x()), y(low, high);
    for (;;) {
      const Pose2 pose{x(engine), y(engine), 0.0};
      if (clearance.is_clear(pose.position(), 0.6)) return pose;
    }
  };
  problem.query.start = place(-22.0, -18.0);
  problem.query.goal = place(16.0, 20.0);
  problem.query.planner.time = 4.0 * test::kPatience;
  for (const std::string name : {"bitstar", "rrtstar", "prmstar", "fmtstar"}) {
    for (const MotionSpace space : {MotionSpace::r2, MotionSpace::se2}) {
      SCOPED_TRACE(name + (space == MotionSpace::r2 ? " in R²" : " in SE(2)"));
      problem.query.planner.name = name;
      // FMT* has no answer before its last sample, however long a sanitizer makes that take.
      problem.query.planner.iterations = counts_its_own_iterations(name) ? std::optional<std::int64_t>(5000) : std::nullopt;
      problem.query.motion.space = space;
      const PlanResult result = plan(problem, {});
      EXPECT_EQ(result.status, PlanStatus::solved);
      RecordProperty(name + (space == MotionSpace::r2 ? "_r2" : "_se2"), std::to_string(result.cost));
    }
  }
}

}  // namespace
}  // namespace alignability
