// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "planner/drivable_area.hpp"
#include "planner/footprint_sweep.hpp"
#include "planner/robot.hpp"
#include "tests/planner/collision_oracle.hpp"

namespace alignability {
namespace {

const std::vector<Eigen::Vector2d> kTruck{{1.6, 0.5}, {-0.4, 0.5}, {-0.4, -0.5}, {1.6, -0.5}};
// Open at the front: what lies between the prongs is not covered.
const std::vector<Eigen::Vector2d> kFork{{0.3, 0.45},   {0.3, 0.3},   {-0.3, 0.3}, {-0.3, 0.45}, {-0.5, 0.45}, {-0.5, -0.45},
                                         {-0.3, -0.45}, {-0.3, -0.3}, {0.3, -0.3}, {0.3, -0.45}, {1.5, -0.45}, {1.5, -0.15},
                                         {0.5, -0.15},  {0.5, 0.15},  {1.5, 0.15}, {1.5, 0.45}};

OccupancyMap scattered(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::bernoulli_distribution occupied(0.004);
  Grid<float> cells({.resolution = 0.1, .origin = {-3.0, 2.0}, .width = 100, .height = 80}, 0.0f);
  for (std::size_t i = 0; i < cells.values().size(); ++i) cells[i] = occupied(engine) ? 1.0f : 0.0f;
  return OccupancyMap(std::move(cells));
}

class Poses {
 public:
  explicit Poses(std::uint64_t seed) : engine_(seed) {}
  Pose2 next() { return {x_(engine_), y_(engine_), yaw_(engine_)}; }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> x_{-3.0, 7.0}, y_{2.0, 10.0}, yaw_{-3.0, 3.0};
};

struct Outline {
  const char* name;
  Robot robot;
};

class EveryFootprint : public testing::TestWithParam<Outline> {
 protected:
  const Robot& robot() const { return GetParam().robot; }
};

TEST_P(EveryFootprint, IsClearWhereItMeetsNoCellThatIsNotFree) {
  const OccupancyMap map = scattered(11);
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(map), robot().footprint);
  Poses poses(3);
  int clear = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose2 at = poses.next();
    EXPECT_EQ(sweep.is_clear(at), !test::collides(map, footprint_at(robot(), at))) << at.x << ' ' << at.y << ' ' << at.yaw;
    clear += sweep.is_clear(at) ? 1 : 0;
  }
  EXPECT_GT(clear, 20);
  EXPECT_LT(clear, 380);
}

TEST_P(EveryFootprint, SweepsNothingThatItMeetsOnTheWay) {
  const OccupancyMap map = scattered(12);
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(map), robot().footprint);
  Poses poses(4);
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> small(-0.8, 0.8);
  int clear = 0;
  int hit_though_both_ends_are_clear = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose2 from = poses.next();
    const Pose2 to{from.x + small(engine), from.y + small(engine), from.yaw + small(engine)};
    const bool motion = sweep.is_clear(from, to);
    EXPECT_EQ(motion, sweep.is_clear(to, from));
    bool every_place = true;
    for (int k = 0; k <= 40 && every_place; ++k) every_place = !test::collides(map, footprint_at(robot(), between(from, to, k / 40.0)));
    EXPECT_TRUE(every_place || !motion) << from.x << ' ' << from.y << ' ' << from.yaw << " to " << to.x << ' ' << to.y << ' ' << to.yaw;
    clear += motion ? 1 : 0;
    hit_though_both_ends_are_clear += !motion && sweep.is_clear(from) && sweep.is_clear(to) ? 1 : 0;
  }
  EXPECT_GT(clear, 20);
  EXPECT_GT(hit_though_both_ends_are_clear, 5);
}

TEST_P(EveryFootprint, IsRefusedAMotionOnlyWhereItComesWithinAThousandthOfACell) {
  const OccupancyMap map = scattered(13);
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(map), robot().footprint);
  Poses poses(6);
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> small(-0.3, 0.3);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose2 from = poses.next();
    const Pose2 to{from.x + small(engine), from.y + small(engine), from.yaw + small(engine)};
    if (!sweep.is_clear(from) || sweep.is_clear(from, to)) continue;
    ++refused;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 1000; ++k) nearest = std::min(nearest, sweep.clearance(between(from, to, k / 1000.0)));
    // Between two of these places an outline moves by less than a millimetre.
    EXPECT_LT(nearest, 1e-3 + 1e-3 * map.geometry().resolution);
  }
  EXPECT_GT(refused, 20);
}

TEST_P(EveryFootprint, IsAllowedALongMotionUpToWhereItCollides) {
  const OccupancyMap map = scattered(15);
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(map), robot().footprint);
  Poses poses(10);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose2 from = poses.next();
    const Pose2 to = poses.next();
    if (!sweep.is_clear(from) || sweep.is_clear(from, to)) continue;
    ++refused;
    double clear = 0.0;
    double obstructed = 1.0;
    while (obstructed - clear > 1e-7) {
      const double middle = 0.5 * (clear + obstructed);
      (sweep.is_clear(from, between(from, to, middle)) ? clear : obstructed) = middle;
    }
    EXPECT_LT(sweep.clearance(between(from, to, obstructed)), 1e-5 + 1e-3 * map.geometry().resolution) << i;
  }
  EXPECT_GT(refused, 50);
}

TEST_P(EveryFootprint, NeverPassesAWallOfOneCell) {
  Grid<float> cells({.resolution = 0.05, .origin = {0.0, 0.0}, .width = 200, .height = 200}, 0.0f);
  for (int i = 0; i < 200; ++i) cells[Cell{i, 100}] = 1.0f;
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(OccupancyMap(std::move(cells))), robot().footprint);
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> x(2.0, 8.0), below(2.0, 4.9), above(5.1, 8.0), yaw(-3.1, 3.1);
  for (int i = 0; i < 2000; ++i) {
    EXPECT_FALSE(sweep.is_clear({x(engine), below(engine), yaw(engine)}, {x(engine), above(engine), yaw(engine)}));
  }
}

TEST_P(EveryFootprint, KeepsItsClearanceFromTheNearestObstacle) {
  const OccupancyMap map = scattered(14);
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(map), robot().footprint);
  Poses poses(9);
  int positive = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose2 at = poses.next();
    const double clearance = sweep.clearance(at);
    if (!sweep.is_clear(at)) {
      EXPECT_EQ(clearance, 0.0);
      continue;
    }
    ++positive;
    for (int k = 0; k < 8; ++k) {
      const double angle = k * radians(45);
      const Pose2 moved{at.x + 0.999 * clearance * std::cos(angle), at.y + 0.999 * clearance * std::sin(angle), at.yaw};
      EXPECT_TRUE(sweep.is_clear(at, moved));
    }
  }
  EXPECT_GT(positive, 20);
}

INSTANTIATE_TEST_SUITE_P(Outlines, EveryFootprint,
                         testing::Values(Outline{"Truck", {.radius = 0.0, .footprint = kTruck}},
                                         Outline{"Fork", {.radius = 0.0, .footprint = kFork}}),
                         [](const testing::TestParamInfo<Outline>& outline) { return outline.param.name; });

TEST(Footprint, FitsExactlyIntoAGapOfItsWidth) {
  Grid<float> cells({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 60, .height = 40}, 0.0f);
  for (int y = 0; y < 40; ++y) {
    if (y < 15 || y >= 25) cells[Cell{30, y}] = 1.0f;
  }
  const FootprintSweep sweep(std::make_shared<const ClearanceMap>(OccupancyMap(std::move(cells))), kTruck);
  EXPECT_TRUE(sweep.is_clear({1.0, 2.0, 0.0}, {4.0, 2.0, 0.0}));
  EXPECT_FALSE(sweep.is_clear({1.0, 2.0 + 1e-6, 0.0}, {4.0, 2.0 + 1e-6, 0.0}));
  EXPECT_FALSE(sweep.is_clear({1.0, 2.0, 0.0}, {4.0, 2.0, 1e-3}));
}

TEST(Footprint, CoversACellThatLiesWhollyInside) {
  Grid<float> cells({.resolution = 0.1, .origin = {0.0, 0.0}, .width = 60, .height = 40}, 0.0f);
  cells[Cell{30, 20}] = 1.0f;
  const auto map = std::make_shared<const ClearanceMap>(OccupancyMap(std::move(cells)));
  EXPECT_FALSE(FootprintSweep(map, kTruck).is_clear({2.5, 2.05, 0.0}));
  // The same cell between the prongs of the fork.
  EXPECT_TRUE(FootprintSweep(map, kFork).is_clear({2.0, 2.05, 0.0}));
}

TEST(Footprint, IsRefusedWhereItIsNoOutline) {
  const auto fault = [](const std::vector<Eigen::Vector2d>& corners) { return fault_of_footprint(corners).value_or("none"); };
  EXPECT_EQ(fault(kTruck), "none");
  EXPECT_EQ(fault({{0.0, 0.0}, {1.0, 0.0}}), "a footprint needs at least 3 corners");
  EXPECT_EQ(fault({{0.0, 0.0}, {1.0, 0.0}, {0.0, std::nan("")}}), "corners must be finite numbers");
  EXPECT_EQ(fault({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}), "the footprint's edges must not cross or touch");
  EXPECT_EQ(fault({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}), "the footprint must not fold back upon itself");
  EXPECT_EQ(fault({{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}), "the footprint must be a polygon with an area");
}

TEST(Footprint, OrARadiusIsWhatAnAreaNeeds) {
  const auto clearance = std::make_shared<ClearanceMap>(scattered(1));
  AlignabilityMap map;
  map.geometry = {.resolution = 1.0, .origin = {-3.0, 2.0}, .width = 10, .height = 8};
  map.layers = {{"alpha", Grid<float>(map.geometry, 0.5f)}};
  const auto risk = std::make_shared<RiskField>(map, scattered(1), RiskOptions{});
  EXPECT_THROW(DrivableArea(clearance, risk, Robot{.radius = 0.0}), std::invalid_argument);
  EXPECT_THROW(DrivableArea(clearance, risk, Robot{.radius = 1.0, .footprint = {{0.0, 0.0}, {1.0, 0.0}}}), std::invalid_argument);
  EXPECT_NO_THROW(DrivableArea(clearance, risk, Robot{.radius = 0.0, .footprint = kTruck}));
}

TEST(Footprint, HasTheRadiiOfItsDisks) {
  EXPECT_DOUBLE_EQ(inscribed_radius({.radius = 0.0, .footprint = kTruck}), 0.4);
  EXPECT_DOUBLE_EQ(circumscribed_radius({.radius = 0.0, .footprint = kTruck}), std::hypot(1.6, 0.5));
  EXPECT_EQ(inscribed_radius({.radius = 0.0, .footprint = {{1, 1}, {2, 1}, {2, 2}}}), 0.0);
  EXPECT_EQ(inscribed_radius({.radius = 0.7, .footprint = {}}), 0.7);
}

}  // namespace
}  // namespace alignability
