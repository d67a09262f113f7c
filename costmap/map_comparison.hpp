// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/distribution.hpp"
#include "costmap/alignability_map.hpp"

namespace alignability {

struct MapComparisonOptions {
  double alpha_critical = 0.1;
  double alpha_safe = 0.4;
  double margin = 0.05;        ///< so much lower α may be before it is a change; >= 0
  double significance = 0.05;  ///< chance of calling any cell lower where none is, and of calling the whole so, in (0, 1)
};

/// A cell that has a value in both maps.
struct ComparedCell {
  Cell cell;  ///< of the first map's grid
  Eigen::Vector2d center;
  double first = 0.0;
  double second = 0.0;
  double chance = 1.0;  ///< of the second reading so low, or lower, where α is no more than the margin lower; NaN where no spread is known
  bool is_lower = false;

  double difference() const { return second - first; }
};

/// Cells that went from one side of a threshold to the other, from the first map to the second.
struct Crossings {
  std::size_t fell = 0;
  std::size_t rose = 0;
};

struct MapComparison {
  std::size_t in_first = 0;         ///< cells with a value
  std::size_t in_second = 0;        ///< likewise
  std::vector<ComparedCell> cells;  ///< those in both, the greatest fall first
  Distribution difference;          ///< second − first, over the cells in both
  Distribution magnitude;           ///< |second − first|
  double rank_correlation = 0.0;    ///< Spearman's; NaN where there is none
  Crossings critical;
  Crossings safe;
  bool is_tested = false;          ///< cell by cell: whether the spread of either map is known
  std::size_t lower = 0;           ///< cells in which the second map reads lower than the margin and the spread of both allow
  double chance = 1.0;             ///< of so many cells falling by more than the margin, were each as likely to as not
  bool is_lower_as_whole = false;  ///< whether more cells fell by more than the margin than chance explains
};

/// Two alignability maps of one site, cell by cell. A cell is lower where α_first − α_second − margin is more than chance explains, α being
/// normally distributed with the medians' variances (π/2)·σ²/n, σ = iqr/1.349: the largest iqr of the cell and the eight around, and at
/// least the median iqr of the map's cells with four samples or more, of the other map's where it has none. Scans of a log follow one
/// another, so a cell of a logged map counts as one sample. Chances are held to the significance over all cells together (Holm 1979). The
/// whole is lower where more than half of the cells fell by more than the margin, by a sign test, which needs no spread. Throws
/// std::invalid_argument that completes "the maps …" where their cells do not coincide or none has a value in both, and for options out
/// of range.
MapComparison compare_maps(const AlignabilityMap& first, const AlignabilityMap& second, const MapComparisonOptions& options);

/// second − first on the first map's grid, NaN where one has no value.
Grid<float> difference_grid(const MapComparison& comparison, const GridGeometry& geometry);

/// How the two were made differently, as far as that moves α: "stride: 1 in the first, 4 in the second".
std::vector<std::string> differences_in_making(const AlignabilityMap& first, const AlignabilityMap& second);

}  // namespace alignability
