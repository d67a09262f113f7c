// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/range.hpp"
#include "core/rank_correlation.hpp"
#include "costmap/cell_offset.hpp"
#include "costmap/logged_map.hpp"

namespace alignability {
namespace {

// From fewer samples an interquartile range says little.
constexpr float kSamplesForASpread = 4.0f;
constexpr double kIqrOfNormal = 1.349;  // standard deviations

// How far a map's values may be off, cell by cell.
class Spread {
 public:
  explicit Spread(const AlignabilityMap& map) : samples_(map.find_layer("samples")), iqr_(map.find_layer("iqr")), logged_(is_logged(map)) {
    if (samples_ == nullptr || iqr_ == nullptr) return;
    std::vector<double> known;
    for (std::size_t i = 0; i < map.geometry.size(); ++i) {
      if ((*samples_)[i] >= kSamplesForASpread) known.push_back((*iqr_)[i]);
    }
    std::ranges::sort(known);
    if (!known.empty()) usual_ = quantile(known, 0.5);
  }

  std::optional<double> usual() const { return usual_; }

  // Of the median in a cell.
  double variance(Cell cell, double usual) const {
    const double deviation = std::max(largest_nearby(cell), usual) / kIqrOfNormal;
    const double samples = samples_ == nullptr || logged_ ? 1.0 : std::max(1.0, static_cast<double>((*samples_)[cell]));
    const double of_median = samples > 2.0 ? 0.5 * std::numbers::pi : 1.0;
    return of_median * deviation * deviation / samples;
  }

 private:
  // In the cell and the eight around: where α is another a step aside, few samples of a cell seldom show it.
  double largest_nearby(Cell cell) const {
    double largest = 0.0;
    for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
      for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
        if (iqr_ == nullptr || !iqr_->geometry().contains({x, y})) continue;
        const double iqr = (*iqr_)[Cell{x, y}];
        if (iqr > largest) largest = iqr;
      }
    }
    return largest;
  }

  const Grid<float>* samples_;
  const Grid<float>* iqr_;
  bool logged_;
  std::optional<double> usual_;
};

void check(const MapComparisonOptions& options) {
  const bool in_order = options.alpha_critical >= 0.0 && options.alpha_critical < options.alpha_safe && options.alpha_safe <= 1.0;
  if (!in_order) throw std::invalid_argument("are compared by thresholds with 0 <= alpha_critical < alpha_safe <= 1");
  if (!kNotNegative.contains(options.margin)) throw std::invalid_argument("are compared with a margin that is not less than 0");
  if (!(options.significance > 0.0 && options.significance < 1.0)) {
    throw std::invalid_argument("are compared at a significance between 0 and 1");
  }
}

std::size_t count_values(const Grid<float>& alpha) {
  return static_cast<std::size_t>(std::ranges::count_if(alpha.values(), [](float value) { return !std::isnan(value); }));
}

// By cell of the first; `offset` leads from the second's cells to the first's.
std::vector<ComparedCell> cells_in_both(const AlignabilityMap& first, const AlignabilityMap& second, Cell offset) {
  std::vector<ComparedCell> cells;
  for (std::size_t i = 0; i < first.geometry.size(); ++i) {
    const Cell cell = first.geometry.cell_of(i);
    const Cell in_second{cell.x - offset.x, cell.y - offset.y};
    if (!second.geometry.contains(in_second)) continue;
    const float a = first.alpha()[cell], b = second.alpha()[in_second];
    if (std::isnan(a) || std::isnan(b)) continue;
    cells.push_back({.cell = cell, .center = first.geometry.center(cell), .first = a, .second = b});
  }
  return cells;
}

// Holm: of m chances in ascending order the k-th, from 0, may be significance/(m − k), as long as all before it kept theirs.
std::size_t mark_lower(std::vector<ComparedCell>& cells, double significance) {
  std::vector<ComparedCell*> ascending;
  for (ComparedCell& cell : cells) ascending.push_back(&cell);
  std::ranges::sort(ascending, {}, [](const ComparedCell* cell) { return cell->chance; });
  std::size_t k = 0;
  for (; k < ascending.size() && ascending[k]->chance <= significance / static_cast<double>(ascending.size() - k); ++k) {
    ascending[k]->is_lower = true;
  }
  return k;
}

// False where neither map has cells with samples enough to know how they spread.
bool set_chances(std::vector<ComparedCell>& cells, const AlignabilityMap& first, const AlignabilityMap& second, Cell offset,
                 double margin) {
  const Spread of_first(first), of_second(second);
  if (!of_first.usual() && !of_second.usual()) {
    for (ComparedCell& cell : cells) cell.chance = std::numeric_limits<double>::quiet_NaN();
    return false;
  }
  const double usual_first = of_first.usual().value_or(of_second.usual().value_or(0.0));
  const double usual_second = of_second.usual().value_or(usual_first);
  for (ComparedCell& cell : cells) {
    const double variance =
        of_first.variance(cell.cell, usual_first) + of_second.variance({cell.cell.x - offset.x, cell.cell.y - offset.y}, usual_second);
    const double fall = -cell.difference() - margin;
    // The upper tail of the normal distribution; without any spread a fall is certain or none.
    cell.chance = variance > 0.0 ? 0.5 * std::erfc(fall / std::sqrt(2.0 * variance)) : (fall > 0.0 ? 0.0 : 1.0);
  }
  return true;
}

// Of at least so many heads in n throws of a coin.
double chance_of_heads(std::size_t least, std::size_t n) {
  const auto log_factorial = [](std::size_t k) { return std::lgamma(static_cast<double>(k) + 1.0); };
  double chance = 0.0;
  for (std::size_t k = least; k <= n; ++k) {
    chance += std::exp(log_factorial(n) - log_factorial(k) - log_factorial(n - k) - static_cast<double>(n) * std::numbers::ln2);
  }
  return std::min(1.0, chance);
}

double chance_of_falls(const std::vector<ComparedCell>& cells, double margin) {
  const auto falls = std::ranges::count_if(cells, [margin](const ComparedCell& cell) { return cell.difference() < -margin; });
  return chance_of_heads(static_cast<std::size_t>(falls), cells.size());
}

Crossings crossings(const std::vector<ComparedCell>& cells, double threshold) {
  Crossings result;
  for (const ComparedCell& cell : cells) {
    result.fell += cell.first >= threshold && cell.second < threshold ? 1 : 0;
    result.rose += cell.first < threshold && cell.second >= threshold ? 1 : 0;
  }
  return result;
}

std::map<std::string, std::string> entries_of(const std::string& yaml) {
  std::map<std::string, std::string> entries;
  std::istringstream lines(yaml);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) entries[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return entries;
}

}  // namespace

MapComparison compare_maps(const AlignabilityMap& first, const AlignabilityMap& second, const MapComparisonOptions& options) {
  check(options);
  const auto offset = offset_of(second.geometry, first.geometry);
  if (!offset) throw std::invalid_argument("do not have the same cells: their corners or sizes differ");
  MapComparison result;
  result.in_first = count_values(first.alpha());
  result.in_second = count_values(second.alpha());
  result.cells = cells_in_both(first, second, *offset);
  if (result.cells.empty()) throw std::invalid_argument("have no cell in common that has a value in both");
  result.is_tested = set_chances(result.cells, first, second, *offset, options.margin);
  if (result.is_tested) result.lower = mark_lower(result.cells, options.significance);
  result.chance = chance_of_falls(result.cells, options.margin);
  result.is_lower_as_whole = result.chance <= options.significance;
  result.critical = crossings(result.cells, options.alpha_critical);
  result.safe = crossings(result.cells, options.alpha_safe);
  std::ranges::stable_sort(result.cells, {}, &ComparedCell::difference);
  std::vector<double> a, b, differences, magnitudes;
  for (const ComparedCell& cell : result.cells) {
    a.push_back(cell.first);
    b.push_back(cell.second);
    differences.push_back(cell.difference());
    magnitudes.push_back(std::abs(cell.difference()));
  }
  result.rank_correlation = rank_correlation(a, b);
  result.difference = distribution_of(std::move(differences));
  result.magnitude = distribution_of(std::move(magnitudes));
  return result;
}

Grid<float> difference_grid(const MapComparison& comparison, const GridGeometry& geometry) {
  Grid<float> grid(geometry, std::numeric_limits<float>::quiet_NaN());
  for (const ComparedCell& cell : comparison.cells) grid[cell.cell] = static_cast<float>(cell.difference());
  return grid;
}

std::vector<std::string> differences_in_making(const AlignabilityMap& first, const AlignabilityMap& second) {
  // How many places of which cells were looked at, and what was asked beside α.
  constexpr std::array kBeside{"samples", "floor", "occupied_above", "max_occupied_share", "readings", "voxel", "range_stddev"};
  auto in_first = entries_of(first.options), in_second = entries_of(second.options);
  for (const char* key : kBeside) {
    in_first.erase(key);
    in_second.erase(key);
  }
  for (const auto& [key, value] : in_first) in_second.try_emplace(key, "none");
  std::vector<std::string> differences;
  for (const auto& [key, value] : in_second) {
    const std::string before = in_first.try_emplace(key, "none").first->second;
    if (before != value) differences.push_back(key + ": " + before + " in the first, " + value + " in the second");
  }
  if (!first.sensor.empty() && !second.sensor.empty() && first.sensor != second.sensor) differences.emplace_back("the sensor file");
  return differences;
}

}  // namespace alignability
