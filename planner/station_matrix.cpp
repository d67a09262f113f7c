// SPDX-License-Identifier: BSD-3-Clause
#include "planner/station_matrix.hpp"

#include "planner/drivable_area.hpp"
#include "planner/goal_field.hpp"
#include "planner/planar_plan.hpp"
#include "planner/planners.hpp"

namespace alignability {
namespace {

constexpr GoalTolerance kExactly{.position = 1e-6, .heading = 1e-6};

PlanQuery between(const Station& from, const Station& to, const PlanQuery& query) {
  PlanQuery between = query;
  between.start = from.pose;
  between.goal = to.pose;
  between.goal_tolerance = kExactly;
  between.planner.name = kDefaultPlanner;
  return between;
}

class Matrix {
 public:
  Matrix(std::span<const Station> stations, const PlanQuery& query, const PlanningFields& fields, const std::stop_token& stop)
      : stations_(stations),
        query_(query),
        fields_(fields),
        stop_(stop),
        motion_{fields.risk, fields.clearance, query.weight, circumscribed_radius(query.robot)},
        lattice_(std::make_shared<const DrivableLattice>(motion_)),
        plans_(stations.size(), std::vector<PlanResult>(stations.size())) {}

  // The ways between a station and those before it, and itself.
  void add(std::size_t to) {
    std::optional<GoalField> field;
    if (has_fields() && is_allowed(to)) field.emplace(lattice_, place(to));
    for (std::size_t from = 0; from <= to; ++from) {
      if (stop_.stop_requested()) throw Interrupted();
      const auto steepest = field && is_allowed(from) ? field->path_from(place(from)) : std::nullopt;
      if (steepest) {
        const PlanarPath path = refined(*steepest, motion_);
        plans_[from][to] = along(path, from, to);
        plans_[to][from] = along({path.rbegin(), path.rend()}, to, from);
      } else {
        plans_[from][to] = searched(from, to);
        plans_[to][from] = searched(to, from);
      }
    }
  }

  std::vector<std::vector<PlanResult>> plans() && { return std::move(plans_); }

 private:
  // Whether what a field tells of the plane is all there is to tell.
  bool has_fields() const {
    return query_.robot.footprint.empty() && !is_curved(query_.motion.space) && !query_.max_error && !query_.max_blind_distance &&
           !fields_.risk->has_headings();
  }
  Eigen::Vector2d place(std::size_t station) const { return stations_[station].pose.position(); }
  bool is_allowed(std::size_t station) const { return motion_.is_allowed(place(station), place(station)); }
  PlanResult along(const PlanarPath& path, std::size_t from, std::size_t to) const {
    return solved_along(path, between(stations_[from], stations_[to], query_), *fields_.risk);
  }
  // Of a footprint, which may pass where its disk does not, of a car, within limits, and where risk depends on heading; and where no way is
  // in the field, as a plan tells why.
  PlanResult searched(std::size_t from, std::size_t to) const {
    PlanResult found = plan(between(stations_[from], stations_[to], query_), fields_, {.stop = stop_});
    if (found.status == PlanStatus::interrupted) throw Interrupted();
    return found;
  }

  std::span<const Station> stations_;
  const PlanQuery& query_;
  const PlanningFields& fields_;
  std::stop_token stop_;
  PlanarMotion motion_;
  std::shared_ptr<const DrivableLattice> lattice_;
  std::vector<std::vector<PlanResult>> plans_;
};

}  // namespace

std::vector<std::vector<PlanResult>> plan_between(std::span<const Station> stations, const PlanQuery& query, const PlanningFields& fields,
                                                  const StationMatrixOptions& options) {
  if (const auto unfit = refusal_of_numbers(query)) throw std::invalid_argument(*unfit);
  if (const auto unfit = refusal_of_space(query)) throw std::invalid_argument(*unfit);
  Matrix matrix(stations, query, fields, options.stop);
  for (std::size_t to = 0; to < stations.size(); ++to) {
    matrix.add(to);
    if (options.progress) options.progress({to + 1, stations.size()});
  }
  return std::move(matrix).plans();
}

}  // namespace alignability
