// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/risk_source.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "costmap/clearance_map.hpp"
#include "costmap/risk_field.hpp"
#include "tests/costmap/ascii_map.hpp"

namespace alignability {
namespace {

using test::ascii_map;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const GridGeometry kMap{.resolution = 0.25, .origin = {-1.0, 2.0}, .width = 32, .height = 24};

double uniform(std::mt19937_64& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

OccupancyMap free_map() { return OccupancyMap(Grid<float>(kMap, 0.0f)); }

Grid<float> random_values(std::mt19937_64& random, const GridGeometry& geometry) {
  Grid<float> values(geometry, 0.0f);
  for (std::size_t i = 0; i < geometry.size(); ++i) values[i] = static_cast<float>(uniform(random, 0.0, 1.0));
  return values;
}

AlignabilityMap map_of(const Grid<float>& alpha) {
  AlignabilityMap map;
  map.geometry = alpha.geometry();
  map.layers.push_back({"alpha", alpha});
  return map;
}

AlignabilityMap random_alignability(std::mt19937_64& random) {
  return map_of(random_values(random, {.resolution = 1.0, .origin = kMap.origin, .width = 8, .height = 6}));
}

RiskSource source_of(const std::string& name, double weight, const Grid<float>& values) {
  return {.name = name, .weight = weight, .values = std::make_shared<const Grid<float>>(values)};
}

// Three grids, none of whose lines are another's: α by the metre, a raster that begins before the map, clearance at corners.
RiskField three_sources(std::mt19937_64& random) {
  const OccupancyMap occupancy = test::random_map(random, kMap, 0.03);
  RiskSource traffic =
      source_of("traffic", 0.7, random_values(random, {.resolution = 0.37, .origin = {-1.2, 1.9}, .width = 23, .height = 17}));
  traffic.safe = 0.3;
  traffic.risky = 0.8;
  RiskSource clearance = source_of(kClearance, 1.6, clearance_values(occupancy));
  clearance.risky = 0.2;
  clearance.safe = 1.1;
  return {random_alignability(random), occupancy, {.alpha_weight = 0.9, .sources = {traffic, clearance}}};
}

// ∫ risk ds by Gauss-Legendre with three nodes between all crossings with lines through the nodes of any of the fields, found by looking.
double dense_integral(const RiskField& field, double length, const std::function<Eigen::Vector2d(double)>& place) {
  const auto are_alike = [&](double a, double b) {
    return std::ranges::all_of(field.layers(), [&](const RiskLayer& layer) {
      const GridGeometry& nodes = layer.risk.nodes().geometry();
      const auto patch = [&](double s) { return (((place(s) - nodes.origin) / nodes.resolution).array() - 0.5).floor().eval(); };
      return (patch(a) == patch(b)).all();
    });
  };
  constexpr int kLooks = 6000;
  std::vector<double> cuts{0.0};
  for (int i = 0; i < kLooks; ++i) {
    double at = length * i / kLooks;
    const double end = length * (i + 1) / kLooks;
    while (!are_alike(at, end)) {
      double before = at;
      double beyond = end;
      for (double middle = 0.5 * (before + beyond); beyond - before > 1e-13 && middle > before && middle < beyond;
           middle = 0.5 * (before + beyond)) {
        (are_alike(at, middle) ? before : beyond) = middle;
      }
      cuts.push_back(beyond);
      at = beyond;
    }
    if (i % 20 == 19) cuts.push_back(end);
  }
  const double outer = std::sqrt(0.6);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double half = 0.5 * (cuts[i + 1] - cuts[i]);
    for (const auto& [at, weight] : {std::pair{-outer, 5.0}, {0.0, 8.0}, {outer, 5.0}}) {
      const Eigen::Vector2d point = place(cuts[i] + half + at * half);
      sum += half * weight / 9.0 * field.risk(point.x(), point.y(), 0.0);
    }
  }
  return sum;
}

Eigen::Vector2d random_place(std::mt19937_64& random) { return {uniform(random, -1.5, 7.5), uniform(random, 1.5, 8.5)}; }

TEST(RiskSources, AddAsOftenAsEachWeighs) {
  // α's risk is ½ everywhere; the raster's rises from 0 at its first centre, x = 0.5, to 1 at its last, x = 3.5.
  const GridGeometry row{.resolution = 1.0, .width = 4, .height = 1};
  RiskSource slope = source_of("slope", 3.0, Grid<float>(row, std::vector{10.0f, 20.0f, 30.0f, 40.0f}));
  slope.safe = 10.0;
  slope.risky = 40.0;
  const RiskField field(map_of(Grid<float>(row, 0.25f)), ascii_map(1.0, {"...."}), {.alpha_weight = 2.0, .sources = {slope}});
  EXPECT_NEAR(field.risk(2.0, 0.5, 0.0), 2.0 * 0.5 + 3.0 * 0.5, 1e-12);
  EXPECT_NEAR(field.risk(3.9, 0.5, 0.0), 1.0 + 3.0, 1e-12);
  EXPECT_NEAR(field.integral({0.5, 0.5, 0.0}, {3.5, 0.5, 0.0}), 3.0 * (1.0 + 1.5), 1e-12);
  EXPECT_NEAR(field.integral({0.0, 0.5, 0.0}, {1.5, 0.5, 0.0}), 1.5 + 3.0 / 6.0, 1e-12);
  ASSERT_EQ(field.layers().size(), 2u);
  EXPECT_EQ(names_of_risks(field.options()), (std::vector<std::string>{"alignability", "slope"}));
  EXPECT_NEAR(field.layers()[1].risk.integral({0.5, 0.5}, {3.5, 0.5}), 1.5, 1e-12) << "unweighted";
}

TEST(RiskSources, ChangeNothingToTheBitWhereTheyWeighNothing) {
  std::mt19937_64 random(1);
  const AlignabilityMap map = random_alignability(random);
  const RiskField without(map, free_map(), {});
  const RiskField with(map, free_map(), {.sources = {source_of("idle", 0.0, random_values(random, kMap))}});
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d a = random_place(random), b = random_place(random);
    EXPECT_EQ(with.risk(a.x(), a.y(), 0.0), without.risk(a.x(), a.y(), 0.0));
    EXPECT_EQ(with.integral({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}), without.integral({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}));
    const Arc arc{{a.x(), a.y(), uniform(random, -3.0, 3.0)}, uniform(random, -1.0, 1.0), uniform(random, -4.0, 4.0)};
    EXPECT_EQ(with.integral(arc), without.integral(arc));
  }
}

TEST(RiskSources, OfAlignabilityTwiceAtHalfItsWeightAreOne) {
  std::mt19937_64 random(2);
  AlignabilityMap map = random_alignability(random);
  for (const std::size_t cell : {3u, 4u, 20u, 21u, 29u}) map.layers.front().values[cell] = kNone;
  RiskSource again = source_of("again", 0.5, map.alpha());
  again.risky = RiskOptions{}.alpha_critical;
  again.safe = RiskOptions{}.alpha_safe;
  for (const UnknownPolicy policy : {UnknownPolicy::risky, UnknownPolicy::neutral}) {
    again.unknown = policy;
    const RiskField one(map, free_map(), {.unknown = policy});
    const RiskField two(map, free_map(), {.unknown = policy, .alpha_weight = 0.5, .sources = {again}});
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector2d a = random_place(random), b = random_place(random);
      EXPECT_EQ(two.risk(a.x(), a.y(), 0.0), one.risk(a.x(), a.y(), 0.0));
      EXPECT_EQ(two.integral({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}), one.integral({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}));
    }
  }
}

TEST(RiskSources, AreIntegratedExactlyAlongSegmentsWhateverTheirGrids) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 40; ++i) {
    const RiskField field = three_sources(random);
    const Eigen::Vector2d a = random_place(random), b = random_place(random);
    const double length = (b - a).norm();
    const double found = field.integral({a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0});
    EXPECT_NEAR(found, dense_integral(field, length, [&](double s) { return Eigen::Vector2d(a + s / length * (b - a)); }), 1e-9 * length);
    EXPECT_EQ(field.integral({b.x(), b.y(), 0.0}, {a.x(), a.y(), 0.0}), found);
    const Eigen::Vector2d between = a + uniform(random, 0.0, 1.0) * (b - a);
    EXPECT_NEAR(field.integral({a.x(), a.y(), 0.0}, {between.x(), between.y(), 0.0}) +
                    field.integral({between.x(), between.y(), 0.0}, {b.x(), b.y(), 0.0}),
                found, 1e-11);
  }
}

TEST(RiskSources, AreIntegratedExactlyAlongArcsWhateverTheirGrids) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 40; ++i) {
    const RiskField field = three_sources(random);
    const Eigen::Vector2d from = random_place(random);
    const Arc arc{{from.x(), from.y(), uniform(random, -3.0, 3.0)}, uniform(random, -1.5, 1.5), uniform(random, -4.0, 4.0)};
    EXPECT_NEAR(field.integral(arc), dense_integral(field, arc.length(), [&](double s) { return arc.at(s).position(); }),
                1e-9 * arc.length());
  }
}

TEST(RiskSources, OfClearanceAreItsThresholdsApartAtTheCornersOfCells) {
  const OccupancyMap map = ascii_map(0.5, {"........", "........", "...#....", "........", "........"});
  const ClearanceMap clearance(map);
  for (const auto& [risky, safe] : {std::pair{0.25, 1.0}, std::pair{1.0, 0.25}}) {
    RiskSource source = source_of(kClearance, 1.0, clearance_values(map));
    source.risky = risky;
    source.safe = safe;
    const RiskField field(map_of(Grid<float>({.resolution = 1.0, .width = 4, .height = 3}, 1.0f)), map, {.sources = {source}});
    for (int y = 0; y <= 5; ++y) {
      for (int x = 0; x <= 8; ++x) {
        const Eigen::Vector2d corner = map.geometry().corner({x, y});
        const double expected = std::clamp((clearance.distance(corner) - safe) / (risky - safe), 0.0, 1.0);
        EXPECT_NEAR(field.risk(corner.x(), corner.y(), 0.0), expected, 1e-6) << x << ' ' << y;
      }
    }
  }
}

TEST(RiskSources, FillTheirBorderAndTakeThePolicyForWhatIsStillUnknown) {
  const GridGeometry row{.resolution = 1.0, .width = 5, .height = 1};
  RiskSource source = source_of("traffic", 1.0, Grid<float>(row, std::vector{0.5f, kNone, kNone, kNone, kNone}));
  const AlignabilityMap safe = map_of(Grid<float>(row, 1.0f));
  const OccupancyMap map = ascii_map(1.0, {"....."});
  const RiskField risky(safe, map, {.sources = {source}});
  source.unknown = UnknownPolicy::neutral;
  const RiskField neutral(safe, map, {.sources = {source}});
  for (const RiskField* field : {&risky, &neutral}) EXPECT_NEAR(field->risk(1.5, 0.5, 0.0), 0.5, 1e-7) << "the border";
  EXPECT_EQ(risky.risk(3.5, 0.5, 0.0), 1.0);
  EXPECT_EQ(neutral.risk(3.5, 0.5, 0.0), 0.0);
  EXPECT_TRUE(risky.is_drivable(Eigen::Vector2d(3.5, 0.5)));
}

TEST(RiskSources, LeaveBlindnessAndDrivabilityToAlpha) {
  std::mt19937_64 random(6);
  const AlignabilityMap map = random_alignability(random);
  const RiskOptions alone{.min_alpha = 0.2};
  RiskOptions options = alone;
  options.sources = {source_of("hot", 9.0, Grid<float>(kMap, 1.0f))};
  const RiskField without(map, free_map(), alone);
  const RiskField with(map, free_map(), options);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d a = random_place(random), b = random_place(random);
    EXPECT_EQ(with.alpha(a.x(), a.y(), 0.0), without.alpha(a.x(), a.y(), 0.0));
    EXPECT_EQ(with.is_drivable(a, b), without.is_drivable(a, b));
  }
}

TEST(RiskSources, WithAFaultAreRefused) {
  const RiskSource good = source_of("traffic", 1.0, Grid<float>(kMap, 0.0f));
  EXPECT_FALSE(fault_of_source(good, kMap).has_value());
  const auto fault_of = [&](const std::function<void(RiskSource&)>& spoil) {
    RiskSource bad = good;
    spoil(bad);
    EXPECT_THROW(RiskField(map_of(Grid<float>(kMap, 0.5f)), free_map(), {.sources = {bad}}), std::invalid_argument);
    return fault_of_source(bad, kMap).value_or("none");
  };
  const auto with_values = [](const Grid<float>& values) {
    return [values](RiskSource& source) { source.values = std::make_shared<const Grid<float>>(values); };
  };
  GridGeometry short_of_it = kMap;
  --short_of_it.width;
  EXPECT_EQ(fault_of([](RiskSource& source) { source.name = "a b"; }),
            "the name of a risk's source must be made of letters, digits, '_' and '-'");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.name.clear(); }),
            "the name of a risk's source must be made of letters, digits, '_' and '-'");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.name = "alignability"; }), "alignability is a risk's source of its own");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.weight = -1.0; }), "a source's weight must be from 0 to 1e+09");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.safe = 1.0; }), "'risky' and 'safe' must differ");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.safe = std::nan(""); }), "'risky' and 'safe' must be finite");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.risky = std::numeric_limits<double>::infinity(); }),
            "'risky' and 'safe' must be finite");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.unknown = UnknownPolicy::blocked; }),
            "only where alignability is unknown may it be blocked");
  EXPECT_EQ(fault_of([](RiskSource& source) { source.values.reset(); }), "a risk's source needs values");
  EXPECT_EQ(fault_of(with_values(Grid<float>(short_of_it, 0.0f))),
            "the raster, x -1 to 6.75 and y 2 to 8, does not cover the map, x -1 to 7 and y 2 to 8");
  EXPECT_EQ(fault_of(with_values(Grid<float>(kMap, -std::numeric_limits<float>::infinity()))), "the raster has infinite values");
  EXPECT_THROW(RiskField(map_of(Grid<float>(kMap, 0.5f)), free_map(), {.sources = {good, good}}), std::invalid_argument);
  EXPECT_THROW(RiskField(map_of(Grid<float>(kMap, 0.5f)), free_map(), {.alpha_weight = -0.1}), std::invalid_argument);
}

TEST(Covers, AllowsForRoundingAlone) {
  GridGeometry other = kMap;
  other.origin.x() += 1e-9;
  EXPECT_TRUE(covers(other, kMap));
  other.origin.x() += 1e-3;
  EXPECT_FALSE(covers(other, kMap));
  EXPECT_TRUE(covers({.resolution = 10.0, .origin = {-2.0, 0.0}, .width = 1, .height = 1}, kMap));
}

}  // namespace
}  // namespace alignability
