// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/risk_field.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>

#include "core/range.hpp"
#include "costmap/heading_layers.hpp"

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
  if (!kCostWeights.contains(options.alpha_weight)) throw std::invalid_argument("alpha_weight must be " + kCostWeights.description());
  return options;
}

// α by heading; a cell without a value at one heading has none at any. Empty of a map without headings.
std::vector<Grid<double>> filled_headings(const AlignabilityMap& map, const OccupancyMap& occupancy) {
  std::vector<Grid<float>> raw;
  for (const Grid<float>* layer : heading_layers(map)) raw.push_back(*layer);
  for (std::size_t cell = 0; cell < map.geometry.size(); ++cell) {
    if (std::ranges::none_of(raw, [&](const Grid<float>& layer) { return std::isnan(layer[cell]); })) continue;
    for (Grid<float>& layer : raw) layer[cell] = std::numeric_limits<float>::quiet_NaN();
  }
  std::vector<Grid<double>> filled;
  for (const Grid<float>& layer : raw) filled.push_back(fill_border(layer, occupancy));
  return filled;
}

// Node by node.
Grid<double> greatest(std::span<const Grid<double>> fields) {
  Grid<double> greatest = fields.front();
  for (const Grid<double>& field : fields.subspan(1)) {
    for (std::size_t i = 0; i < greatest.values().size(); ++i) greatest[i] = std::max(greatest[i], field[i]);
  }
  return greatest;
}

}  // namespace

std::vector<std::string> names_of_risks(const RiskOptions& options) {
  std::vector<std::string> names{kAlignability};
  for (const RiskSource& source : options.sources) names.push_back(source.name);
  return names;
}

RiskField::RiskField(const AlignabilityMap& map, const OccupancyMap& occupancy, const RiskOptions& options) : options_(checked(options)) {
  std::vector<Grid<double>> by_heading = filled_headings(map, occupancy);
  alpha_ = BilinearField(by_heading.empty() ? fill_border(map.alpha(), occupancy) : greatest(by_heading));
  const auto risk_of_alpha = [&](const Grid<double>& alpha) {
    return risk_nodes(alpha, options.alpha_critical, options.alpha_safe, options.unknown);
  };
  layers_.push_back({kAlignability, options.alpha_weight, risk_of_alpha(alpha_.nodes())});
  if (!by_heading.empty()) {
    std::vector<BilinearField> alphas, risks;
    for (Grid<double>& alpha : by_heading) {
      risks.push_back(risk_of_alpha(alpha));
      alphas.emplace_back(std::move(alpha));
    }
    alpha_headings_ = HeadingField(std::move(alphas));
    layers_.front().headings = HeadingField(std::move(risks));
  }
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

double RiskField::risk(double x, double y, double yaw) const {
  return sum([&](const RiskLayer& layer) { return layer.at({x, y, yaw}); });
}

double RiskField::least_risk(const Eigen::Vector2d& point) const {
  return sum([&](const RiskLayer& layer) { return layer.risk.at(point); });
}

double RiskField::alpha(double x, double y, double yaw) const {
  return has_headings() ? alpha_headings_.at({x, y, yaw}) : alpha_.at({x, y});
}

bool RiskField::is_blind(double alpha) const {
  return std::isnan(alpha) ? options_.unknown != UnknownPolicy::neutral : alpha < options_.alpha_critical;
}

bool RiskField::has_value(Cell cell) const { return alpha_.nodes().geometry().contains(cell) && !std::isnan(alpha_.nodes()[cell]); }

bool RiskField::is_known(const Eigen::Vector2d& point) const {
  if (options_.unknown != UnknownPolicy::blocked) return true;
  const auto cell = alpha_.nodes().geometry().cell_near(point);
  return cell && has_value(*cell);
}

bool RiskField::is_known_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (options_.unknown != UnknownPolicy::blocked) return true;
  bool known = true;
  detail::traverse(alpha_.nodes().geometry(), from, to, [&](Cell cell, double, double) { known = known && has_value(cell); });
  return known;
}

bool RiskField::is_drivable_at(const Pose2& pose) const {
  if (!has_headings()) return is_drivable(pose.position());
  return is_known(pose.position()) && (!options_.min_alpha || alpha_headings_.at(pose) >= *options_.min_alpha);
}

bool RiskField::is_drivable_along(const Pose2& from, const Pose2& to) const {
  if (!has_headings()) return is_drivable(from.position(), to.position());
  if (!is_drivable_at(from) || !is_drivable_at(to) || !is_known_between(from.position(), to.position())) return false;
  if (!options_.min_alpha) return true;
  const double floor = *options_.min_alpha - kRounding;
  bool kept = true;
  alpha_headings_.visit(from, to, [&](double, const Cubic& alpha) { kept = kept && alpha.is_number() && alpha.least() >= floor; });
  return kept;
}

bool RiskField::is_drivable(const Eigen::Vector2d& point) const {
  if (!is_known(point)) return false;
  if (!options_.min_alpha) return true;
  if (!has_headings()) return alpha_.at(point) >= *options_.min_alpha;
  return std::ranges::any_of(alpha_headings_.at_headings(),
                             [&](const BilinearField& alpha) { return alpha.at(point) >= *options_.min_alpha; });
}

bool RiskField::is_drivable(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  if (!is_drivable(from) || !is_drivable(to) || !is_known_between(from, to)) return false;
  if (!options_.min_alpha) return true;
  const double floor = *options_.min_alpha - kRounding;
  if (has_headings()) return alpha_headings_.reaches(floor, from, to);
  bool drivable = true;
  alpha_.visit(from, to, [&](double, const Quadratic& alpha) { drivable = drivable && alpha.is_number() && alpha.least() >= floor; });
  return drivable;
}

bool RiskField::is_drivable(const Arc& arc) const {
  if (!is_drivable_at(arc.start) || !is_drivable_at(arc.end())) return false;
  bool drivable = true;
  if (options_.unknown == UnknownPolicy::blocked && arc.travel != 0.0) {
    detail::traverse(alpha_.nodes().geometry(), arc, [&](Cell cell, double, double) { drivable = drivable && has_value(cell); });
  }
  if (!options_.min_alpha) return drivable;
  const double floor = *options_.min_alpha - kRounding;
  // What is no number is not above the floor.
  const auto keep = [&](const auto& alpha) { drivable = drivable && alpha.mean() >= floor && alpha.least() >= floor; };
  has_headings() ? alpha_headings_.visit(arc, keep) : alpha_.visit(arc, keep);
  return drivable;
}

RiskField RiskField::best_over_headings() const {
  RiskField best = *this;
  best.alpha_headings_ = {};
  best.layers_.front().headings = {};
  return best;
}

RiskField RiskField::with_floor(std::optional<double> min_alpha) const {
  RiskField field = *this;
  field.options_.min_alpha = min_alpha;
  checked(field.options_);
  return field;
}

}  // namespace alignability
