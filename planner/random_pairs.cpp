// SPDX-License-Identifier: BSD-3-Clause
#include "planner/random_pairs.hpp"

#include <numbers>
#include <random>
#include <stdexcept>

namespace alignability {
namespace {

class PlaceSource {
 public:
  PlaceSource(const DrivableArea& area, std::uint64_t seed) : area_(area), engine_(seed) {}

  Pose2 next() {
    constexpr int kDraws = 100'000;
    const GridGeometry& map = area_.geometry();
    for (int draw = 0; draw < kDraws; ++draw) {
      const double x = map.origin.x() + share() * map.extent().x();
      const double y = map.origin.y() + share() * map.extent().y();
      const Pose2 pose{x, y, std::numbers::pi * (2.0 * share() - 1.0)};
      if (area_.contains(pose)) return pose;
    }
    throw std::runtime_error("the robot found no place on the map in " + std::to_string(kDraws) + " random draws");
  }

 private:
  // The standard's distributions differ from one library to the next.
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  const DrivableArea& area_;
  std::mt19937_64 engine_;
};

}  // namespace

std::vector<PosePair> random_pairs(const DrivableArea& area, double goal_tolerance, std::size_t count, std::uint64_t seed) {
  PlaceSource places(area, seed);
  std::vector<PosePair> pairs;
  while (pairs.size() < count) {
    const Pose2 start = places.next();
    const Pose2 goal = places.next();
    if (area.may_connect(start, goal, goal_tolerance)) pairs.push_back({start, goal});
  }
  return pairs;
}

std::vector<Comparison> compare_pairs(const PlanQuery& query, const PlanningFields& fields, const PairOptions& options) {
  const DrivableArea area(fields.clearance, fields.risk, query.robot);
  std::vector<Comparison> comparisons;
  for (const PosePair& pair : random_pairs(area, query.goal_tolerance.position, options.count, options.seed)) {
    PlanQuery between_them = query;
    between_them.start = pair.start;
    between_them.goal = pair.goal;
    comparisons.push_back(compare(between_them, fields, options.plan));
    if (options.plan.stop.stop_requested()) throw Interrupted();
    if (options.progress) options.progress({comparisons.size(), options.count});
  }
  return comparisons;
}

}  // namespace alignability
