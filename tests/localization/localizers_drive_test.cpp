// SPDX-License-Identifier: BSD-3-Clause
// The localizers on simulated scans: they hold in a rich room, and drift as their odometry does in a plain corridor.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <variant>

#include "localization/odometry.hpp"
#include "localization/scan_matcher.hpp"
#include "tests/localization/site.hpp"

namespace alignability {
namespace {

using test::Site;

enum class Kind { sum, product, regularized_sum, regularized_product, matcher };

constexpr std::array kKinds{Kind::sum, Kind::product, Kind::regularized_sum, Kind::regularized_product, Kind::matcher};

std::string name_of(Kind kind) {
  constexpr std::array kNames{"Sum", "Product", "RegularizedSum", "RegularizedProduct", "Matcher"};
  return kNames[static_cast<std::size_t>(kind)];
}

class Localizer {
 public:
  Localizer(Kind kind, const Site& site, const Pose2& start, const Pose2& deviations, std::uint64_t seed)
      : localizer_(make(kind, site, start, deviations, seed)) {}

  void move(const Pose2& motion) {
    std::visit([&](auto& localizer) { localizer.move(motion); }, localizer_);
  }
  void see(const std::vector<Eigen::Vector3f>& points) {
    if (NdtMcl* const mcl = std::get_if<NdtMcl>(&localizer_)) return mcl->see(Ndt(points, {}));
    std::get<ScanMatcher>(localizer_).see(points);
  }
  Pose2 estimate() const {
    return std::visit([](const auto& localizer) { return localizer.estimate(); }, localizer_);
  }

 private:
  using Either = std::variant<NdtMcl, ScanMatcher>;
  static Either make(Kind kind, const Site& site, const Pose2& start, const Pose2& deviations, std::uint64_t seed) {
    if (kind == Kind::matcher) return ScanMatcher(site.planes, start, deviations, {});
    NdtMclOptions options;
    const bool product = kind == Kind::product || kind == Kind::regularized_product;
    options.combination = product ? CellCombination::product : CellCombination::sum;
    if (kind == Kind::regularized_sum || kind == Kind::regularized_product) options.regularization.emplace();
    return NdtMcl(site.ndt, start, deviations, options, seed);
  }

  Either localizer_;
};

// What odometry reports in the rich room.
constexpr OdometryError kRoundError{.scale_bias = 0.02, .position_noise = 0.01, .heading_noise = 0.005};

TEST(Localizers, KeepFiveCentimetresForAMinuteInARichRoom) {
  const Site site = test::rich_site();
  const Pose2 off{test::kRoundStart.x + 0.1, test::kRoundStart.y - 0.1, radians(1)};
  std::map<Kind, Localizer> localizers;
  for (const Kind kind : kKinds) localizers.emplace(kind, Localizer(kind, site, off, {0.1, 0.1, radians(1)}, 1));
  Odometry odometry(kRoundError, 1);
  Pose2 truth = test::kRoundStart;
  std::map<Kind, double> sums;
  constexpr std::uint64_t kConverged = 50, kSteps = 600;  // of a tenth of a second
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    truth = moved(truth, test::motion_around(step));
    const Pose2 report = odometry.report(test::motion_around(step));
    const auto seen = site.seen_from(truth, step);
    for (auto& [kind, localizer] : localizers) {
      localizer.move(report);
      localizer.see(seen);
      if (step >= kConverged) sums[kind] += test::distance(localizer.estimate(), truth);
    }
  }
  for (const auto& [kind, sum] : sums) {
    const double mean = sum / static_cast<double>(kSteps - kConverged);
    RecordProperty("MeanError" + name_of(kind), std::to_string(mean));
    EXPECT_LT(mean, 0.05) << name_of(kind);
  }
}

// In six directions off, by filters told to be 0.5 m and 2 degrees unsure, as the implementation starts its own. The matcher always
// converges, and so does NDT-MCL with regularization. As published, with 100 particles, it does in about half of the cases, in either
// combination: the likelihood's maximum is at the truth, but some 0.1 m and 1.5 degrees wide, which in two starts of three holds no
// particle at first. The product's first scan leaves one particle, the sum's first hundred gather where they happen to.
TEST(Localizers, ConvergeFromHalfAMetreAndTwoDegreesOffInARichRoom) {
  const Site site = test::rich_site();
  constexpr std::uint64_t kStarts = 6, kSteps = 100;
  std::vector<std::pair<Kind, Localizer>> localizers;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    const double direction = radians(60.0 * static_cast<double>(start));
    const Pose2 off{test::kRoundStart.x + 0.5 * std::cos(direction), test::kRoundStart.y + 0.5 * std::sin(direction),
                    radians(start % 2 == 0 ? 2 : -2)};
    for (const Kind kind : kKinds) localizers.emplace_back(kind, Localizer(kind, site, off, {0.5, 0.5, radians(2)}, start));
  }
  Odometry odometry(kRoundError, 1);
  Pose2 truth = test::kRoundStart;
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    truth = moved(truth, test::motion_around(step));
    const Pose2 report = odometry.report(test::motion_around(step));
    const auto seen = site.seen_from(truth, step);
    for (auto& [kind, localizer] : localizers) {
      localizer.move(report);
      localizer.see(seen);
    }
  }
  std::map<Kind, int> converged;
  for (const auto& [kind, localizer] : localizers) converged[kind] += test::distance(localizer.estimate(), truth) < 0.05 ? 1 : 0;
  for (const Kind kind : kKinds) RecordProperty("Converged" + name_of(kind), converged[kind]);
  for (const Kind kind : {Kind::regularized_sum, Kind::regularized_product, Kind::matcher})
    EXPECT_EQ(converged[kind], kStarts) << name_of(kind);
  EXPECT_GE(converged[Kind::product], kStarts / 3);
  EXPECT_GE(converged[Kind::sum], kStarts / 3);
}

// Along a plain corridor nothing but odometry tells how far the robot is. After L metres its reports are off by bias·L and by a deviation
// of σ·√L. A particle filter that weighs by nothing draws survivors whatever their x: each particle's x is a walk of L/d steps, of q·d each
// by the filter's own noise q a metre, so that their mean deviates by at most that walk's √(L/d)·q·d = q·√(L·d). The matcher draws nothing.
// But cells of maps imprint a period on what particles weigh, which pulls forth and back: hence the mean over starts all over a cell.
struct Corridor {
  static constexpr double kBias = 0.03, kWhite = 0.02;  // of the odometry [m/√m]
  static constexpr double kStep = 0.25;                 // d [m]
  static constexpr int kSteps = 80, kPhases = 8;
  static constexpr double kMetres = kStep * kSteps;
  static constexpr double kStart = 0.02;  // deviation at the start [m]

  static double predicted() { return kBias * kMetres; }
  static double deviation() {
    const double q = MotionNoise{}.per_metre.x;
    return std::sqrt(kStart * kStart + kWhite * kWhite * kMetres + q * q * kMetres * kStep);
  }
};

TEST(Localizers, DriftAlongAPlainCorridorAsOdometryDoesButNotAcross) {
  const Site site = test::plain_site();
  std::map<Kind, double> sums;
  for (int phase = 0; phase < Corridor::kPhases; ++phase) {
    const auto seed = static_cast<std::uint64_t>(phase);
    Pose2 truth{NdtOptions{}.cell * phase / Corridor::kPhases, 0.2, 0.0};
    std::map<Kind, Localizer> localizers;
    for (const Kind kind : kKinds) localizers.emplace(kind, Localizer(kind, site, truth, {Corridor::kStart, 0.02, radians(0.5)}, seed));
    Odometry odometry({.scale_bias = Corridor::kBias, .position_noise = Corridor::kWhite}, seed);
    for (std::uint64_t step = 0; step < Corridor::kSteps; ++step) {
      truth = moved(truth, {Corridor::kStep, 0.0, 0.0});
      const Pose2 report = odometry.report({Corridor::kStep, 0.0, 0.0});
      const auto seen = site.seen_from(truth, 1000 * seed + step);
      for (auto& [kind, localizer] : localizers) {
        localizer.move(report);
        localizer.see(seen);
      }
    }
    for (const auto& [kind, localizer] : localizers) {
      SCOPED_TRACE(name_of(kind) + ", phase " + std::to_string(phase));
      const Pose2 estimate = localizer.estimate();
      EXPECT_LT(std::abs(estimate.y - truth.y), 0.1);
      EXPECT_NEAR(estimate.x - truth.x, Corridor::predicted(), 4.0 * Corridor::deviation());
      sums[kind] += estimate.x - truth.x;
    }
  }
  for (const auto& [kind, sum] : sums) {
    RecordProperty("MeanDrift" + name_of(kind), std::to_string(sum / Corridor::kPhases));
    EXPECT_NEAR(sum / Corridor::kPhases, Corridor::predicted(), 3.0 * Corridor::deviation() / std::sqrt(Corridor::kPhases))
        << name_of(kind);
  }
}

class EachLocalizer : public testing::TestWithParam<Kind> {};

TEST_P(EachLocalizer, GoesAlikeWithTheSameSeed) {
  const Site site = test::rich_site();
  const auto estimate = [&](std::uint64_t seed) {
    Localizer localizer(GetParam(), site, {2.1, 2.0, 0.0}, {0.2, 0.2, 0.05}, seed);
    for (std::uint64_t step = 0; step < 5; ++step) {
      localizer.move({0.1, 0.0, 0.0});
      localizer.see(site.seen_from({2.1 + 0.1 * static_cast<double>(step), 2.0, 0.0}, step));
    }
    return localizer.estimate();
  };
  EXPECT_EQ(estimate(1), estimate(1));
  EXPECT_EQ(estimate(1) == estimate(2), GetParam() == Kind::matcher) << "which draws no numbers";
}

TEST_P(EachLocalizer, GoesBadlyButFinitelyOnAWrongMap) {
  const Site site = test::rich_site();
  const Site elsewhere = test::plain_site();
  Localizer localizer(GetParam(), elsewhere, {2.0, 2.0, 0.0}, {0.2, 0.2, 0.05}, 1);
  for (std::uint64_t step = 0; step < 20; ++step) {
    localizer.move({0.1, 0.0, 0.05});
    localizer.see(site.seen_from({2.0, 2.0, 0.0}, step));
  }
  EXPECT_TRUE(localizer.estimate().position().allFinite());
  EXPECT_TRUE(std::isfinite(localizer.estimate().yaw));
}

INSTANTIATE_TEST_SUITE_P(Kind, EachLocalizer, testing::ValuesIn(kKinds), [](const auto& instance) { return name_of(instance.param); });

}  // namespace
}  // namespace alignability
