// SPDX-License-Identifier: BSD-3-Clause
#include "planner/path_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace alignability {
namespace {

RiskField field_of(Grid<float> alpha, UnknownPolicy unknown) {
  const OccupancyMap occupancy(Grid<float>(alpha.geometry(), 0.0f));
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", std::move(alpha)});
  return RiskField(map, occupancy, {.unknown = unknown});
}

GridGeometry strip(int cells) { return {.resolution = 1.0, .origin = {0.0, 0.0}, .width = cells, .height = 3}; }

TEST(PathFigures, AddUpWhatIsBlindAndHowLongAtAStretch) {
  Grid<float> alpha(strip(30), 0.5f);
  for (int y = 0; y < 3; ++y) {
    for (const int x : {5, 6, 7, 20}) alpha[Cell{x, y}] = 0.0f;
  }
  const std::vector<Pose2> path{{0.5, 1.5, 0.0}, {29.5, 1.5, 0.0}};
  const PathFigures figures = measure(path, field_of(alpha, UnknownPolicy::risky));
  // α falls from 0.5 to 0 over a metre: it is below 0.1 for the last fifth of it.
  EXPECT_NEAR(figures.length, 29.0, 1e-12);
  EXPECT_NEAR(figures.longest_blind, 2.4, 1e-9);
  EXPECT_NEAR(figures.blind_length, 2.8, 1e-9);
  EXPECT_NEAR(figures.alpha_min, 0.0, 1e-12);
}

TEST(PathFigures, CarryAStretchOverTheCornersOfAPath) {
  const RiskField risk = field_of(Grid<float>(strip(30), 0.0f), UnknownPolicy::risky);
  const std::vector<Pose2> path{{1.0, 1.0, 0.0}, {5.0, 1.0, 0.0}, {5.0, 2.0, 1.0}, {9.0, 2.0, 0.0}};
  const PathFigures figures = measure(path, risk);
  EXPECT_NEAR(figures.longest_blind, 9.0, 1e-12);
  EXPECT_NEAR(figures.turned, 2.0, 1e-12);
  EXPECT_NEAR(figures.risk_integral, 9.0, 1e-12);
}

// Where α is just the threshold, beside cells where it is not: a car's straight way keeps to it all along.
TEST(PathFigures, OfACarAreThoseOfAWalkWhereAlphaKeepsToTheThreshold) {
  Grid<float> alpha(strip(10), 0.25f);
  for (const int x : {1, 4, 5, 8}) alpha[Cell{x, 2}] = 0.9f;
  const OccupancyMap occupancy(Grid<float>(alpha.geometry(), 0.0f));
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", alpha});
  const RiskField risk(map, occupancy, {.alpha_critical = 0.25});
  Curve straight({0.5, 1.5, 0.0});
  straight.append(0.0, 9.0);
  EXPECT_EQ(measure(std::vector{straight}, risk).blind_length, 0.0);
  EXPECT_EQ(measure(std::vector<Pose2>{{0.5, 1.5, 0.0}, {9.5, 1.5, 0.0}}, risk).blind_length, 0.0);
}

TEST(PathFigures, CountTheUnevaluatedAsBlindUnderRiskyAndNotUnderNeutral) {
  Grid<float> alpha(strip(30), 0.5f);
  for (int y = 0; y < 3; ++y) {
    for (int x = 10; x < 20; ++x) alpha[Cell{x, y}] = std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<Pose2> path{{0.5, 1.5, 0.0}, {29.5, 1.5, 0.0}};
  // The outermost unevaluated cells are filled from their neighbours; beyond their centres nothing is known.
  const PathFigures risky = measure(path, field_of(alpha, UnknownPolicy::risky));
  EXPECT_NEAR(risky.blind_length, 9.0, 1e-9);
  EXPECT_NEAR(risky.alpha_mean, 0.5, 1e-6);
  Curve straight(path.front());
  straight.append(0.0, 29.0);
  const PathFigures driven = measure(std::vector{straight}, field_of(alpha, UnknownPolicy::risky));
  EXPECT_NEAR(driven.blind_length, 9.0, 1e-9);
  EXPECT_NEAR(driven.evaluated_length, 20.0, 1e-9);
  const PathFigures neutral = measure(path, field_of(alpha, UnknownPolicy::neutral));
  EXPECT_EQ(neutral.blind_length, 0.0);
  EXPECT_EQ(neutral.risk_integral, 0.0);
}

TEST(PathFigures, AgreeWithAFineWalkOnRandomFields) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 0.3f);
    Grid<float> alpha({.resolution = 1.0, .origin = {-5.0, -5.0}, .width = 10, .height = 10}, 0.0f);
    for (std::size_t i = 0; i < alpha.values().size(); ++i) alpha[i] = uniform(engine);
    const RiskField risk = field_of(alpha, UnknownPolicy::risky);
    std::uniform_real_distribution<double> place(-4.9, 4.9);
    std::vector<Pose2> path;
    for (int i = 0; i < 6; ++i) path.push_back({place(engine), place(engine), 0.0});
    double blind = 0.0, alpha_integral = 0.0, alpha_min = 1.0, length = 0.0;
    constexpr int kSteps = 100000;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const double step = std::hypot(path[i + 1].x - path[i].x, path[i + 1].y - path[i].y) / kSteps;
      for (int k = 0; k < kSteps; ++k) {
        const double t = (k + 0.5) / kSteps;
        const double here = risk.alpha(path[i].x + t * (path[i + 1].x - path[i].x), path[i].y + t * (path[i + 1].y - path[i].y), 0.0);
        if (here < 0.1) blind += step;
        alpha_integral += here * step;
        alpha_min = std::min(alpha_min, here);
        length += step;
      }
    }
    const PathFigures figures = measure(path, risk);
    EXPECT_NEAR(figures.length, length, 1e-6);
    EXPECT_NEAR(figures.blind_length, blind, 1e-2);
    EXPECT_NEAR(figures.alpha_mean, alpha_integral / length, 1e-6);
    EXPECT_NEAR(figures.alpha_min, alpha_min, 1e-4);
    EXPECT_LE(figures.alpha_min, alpha_min + 1e-12);
  }
}

TEST(PathFigures, SamplesAreNoFurtherApartThanAskedAndKeepThePathsPoses) {
  const RiskField risk = field_of(Grid<float>(strip(30), 0.25f), UnknownPolicy::risky);
  const std::vector<Pose2> path{{1.0, 1.0, 0.0}, {5.03, 1.0, 3.0}, {5.03, 2.0, -3.0}};
  const std::vector<PathSample> samples = sample(path, risk, 0.1);
  EXPECT_EQ(samples.front().pose, path.front());
  EXPECT_EQ(samples.back().pose, path.back());
  EXPECT_NEAR(samples.back().s, 5.03, 1e-12);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    EXPECT_LE(samples[i + 1].s - samples[i].s, 0.1 + 1e-12);
    EXPECT_LE(std::abs(normalized_angle(samples[i + 1].pose.yaw - samples[i].pose.yaw)), 0.1);
    EXPECT_NEAR(samples[i].alpha, 0.25, 1e-12);
    EXPECT_NEAR(samples[i].risk, 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace alignability
