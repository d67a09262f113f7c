// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/bootstrap.hpp"
#include "costmap/grid.hpp"
#include "localization/drive.hpp"

namespace alignability {

/// What happened in a cell of the alignability map over several runs.
struct CellErrors {
  Cell cell;
  double error = 0.0;   ///< mean over the scans of each run, then over the runs that came by [m] (Castellano-Quero et al., Eq. 3)
  double growth = 0.0;  ///< by how much the error grew within the cell, per metre driven there; NaN where no metre was
  double metres = 0.0;  ///< driven in it, in all runs
};

/// The errors of one localizer, given by number, over runs of some paths, by the cell that the robot was in; cells that no run came by are
/// left out. In the order of the grid. Scans within `settling` [m] of the start, where the first guess is still being mended, do not count.
std::vector<CellErrors> cell_errors(std::span<const std::vector<Drive>> paths, std::size_t localizer, const GridGeometry& cells,
                                    double settling);

/// How a statement on cells fared: those with a reading on one side of a threshold, and how many of these keep what is said of them.
struct Statement {
  enum class Verdict {
    holds,
    fails,
    untested,  ///< fewer than kLeastCells cells on either side of the threshold
  };

  std::size_t cells = 0;       ///< of which something is said
  std::size_t exceptions = 0;  ///< of these, cells that are otherwise
  std::size_t others = 0;      ///< on the other side
  Verdict verdict() const;
};

inline constexpr std::size_t kLeastCells = 20;

/// How well a reading of cells, such as α, tells the error in them.
struct Prediction {
  Interval error;                   ///< rank correlation with the mean error; −1 where a greater reading always is a smaller error
  Interval growth;                  ///< with its growth per metre
  Statement large_only_where_poor;  ///< no error above 0.3 m where the reading is at least 0.1
  Statement small_where_rich;       ///< errors below 0.1 m where the reading is above 0.4
};

/// Over cells that have a reading, of the same geometry; intervals by drawing runs anew, those of one number on all paths together, not
/// cells, which are not independent of one another. O(resamples · samples).
Prediction prediction(std::span<const std::vector<Drive>> paths, std::size_t localizer, const Grid<float>& reading, double settling,
                      const BootstrapOptions& options);

}  // namespace alignability
