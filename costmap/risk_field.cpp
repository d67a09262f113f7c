// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/risk_field.hpp"

#include "core/range.hpp"

namespace alignability {
namespace {

constexpr double kRounding = 1e-12;  // of α along a segment, whose ends are exact

BilinearField risk_nodes(Grid<double> values, double risky, double safe, UnknownPolicy unknown) {
  for (std::size_t i = 0; i < values.values().size(); ++i) values[i] = risk_of(values[i], risky, safe, unknown);
  return BilinearField(std::move(values));
}

const RiskOptions& checked(const RiskOptions& options) {
  if (!(options.alpha_critical >= 0.0 && options.alpha_critical < options.alpha_safe && options.alpha_safe <= 1.0)) {
    throw std::invalid_argument("risk thresholds must satisfy 0 <= alpha_critical < alpha_safe <= 1");
  }
  if (options.min_alpha && !(*options.min_alpha >= 0.0 && *options.min_alpha <= 1.0)) {
    throw std::invalid_argument("min_alpha must be in [0, 1]");
  }
  if (!kNotNegative.contains(options.alpha_weight)) throw std::invalid_argument("alpha_weight must be at least 0");
  return options;
}

}  // namespace

std::vector<std::string> names_of_risks(const RiskOptions& options) {
  std::vector<std::string> names{kAlignability};
  for (const RiskSource& source : options.sources) names.push_back(source.name);
  return names;
}

RiskField::RiskField(const AlignabilityMap& map, const OccupancyMap& occupancy, const RiskOptions& options)
    : options_(checked(options)), alpha_(fill_border(map.alpha(), occupancy)) {
  layers_.push_back(
      {kAlignability, options.alpha_weight, risk_nodes(alpha_.nodes(), options.alpha_critical, options.alpha_safe, options.unknown)});
  for (const RiskSource& source : options.sources) {
    if (const auto fault = fault_of_source(source, occupancy.geometry())) throw std::invalid_argument(source.name + ": " + *fault);
    if (std::ranges::count(options.sources, source.name, &RiskSource::name) > 1) {
      throw std::invalid_argument("there are two sources of risk named '" + source.name + "'");
    }
    layers_.push_back(
        {source.name, source.weight, risk_nodes(fill_border(*source.values, occupancy), source.risky, source.safe, source.unknown)});
  }
  const auto counts = [](const RiskLayer& layer) { return layer.weight != 0.0; };
  is_alpha_alone_ = options.alpha_weight == 1.0 && std::ranges::count_if(layers_, counts) == 1;
}

double RiskField::risk(double x, double y, double /*yaw*/) const {
  return sum([&](const BilinearField& risk) { return risk.at({x, y}); });
}

double RiskField::alpha(double x, double y, double /*yaw*/) const { return alpha_.at({x, y}); }

bool RiskField::is_blind(double alpha) const {
  return std::isnan(alpha) ? options_.unknown != UnknownPolicy::neutral : alpha < options_.alpha_critical;
}

bool RiskField::has_value(Cell cell) const { return alpha_.nodes().geometry().contains(cell) && !std::isnan(alpha_.nodes()[cell]); }

bool RiskField::is_drivable(const Eigen::Vector2d& point) const {
  if (options_.unknown == UnknownPolicy::blocked) {
    const auto cell = alpha_.nodes().geometry().cell_near(point);
    if (!cell || !has_value(*cell)) return false;
  }
  return !options_.min_alpha || alpha_.at(point) >= *options_.min_alpha;
}

bool RiskField::is_drivable(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (!is_drivable(from) || !is_drivable(to)) return false;
  bool drivable = true;
  if (options_.unknown == UnknownPolicy::blocked) {
    detail::traverse(alpha_.nodes().geometry(), from, to, [&](Cell cell, double, double) { drivable = drivable && has_value(cell); });
  }
  if (options_.min_alpha) {
    const double floor = *options_.min_alpha - kRounding;
    alpha_.visit(from, to, [&](double, const Quadratic& alpha) { drivable = drivable && alpha.is_number() && alpha.least() >= floor; });
  }
  return drivable;
}

bool RiskField::is_drivable(const Arc& arc) const {
  if (!is_drivable(arc.start.position()) || !is_drivable(arc.end().position())) return false;
  bool drivable = true;
  if (options_.unknown == UnknownPolicy::blocked && arc.travel != 0.0) {
    detail::traverse(alpha_.nodes().geometry(), arc, [&](Cell cell, double, double) { drivable = drivable && has_value(cell); });
  }
  if (options_.min_alpha) {
    const double floor = *options_.min_alpha - kRounding;
    // What is no number is not above the floor.
    alpha_.visit(arc, [&](const BilinearAlongArc& alpha) { drivable = drivable && alpha.mean() >= floor && alpha.least() >= floor; });
  }
  return drivable;
}

RiskField RiskField::with_floor(std::optional<double> min_alpha) const {
  RiskField field = *this;
  field.options_.min_alpha = min_alpha;
  checked(field.options_);
  return field;
}

}  // namespace alignability
