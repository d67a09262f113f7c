// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "alignability/alignability.hpp"
#include "alignability/cell_work.hpp"

namespace alignability::detail {

/// The layers of a map made with such options: alpha, samples, iqr, weak_x, weak_y, weak_z, then those of the readings, then α at each of
/// so many headings, where there is more than one.
std::vector<std::string> layer_names(const AlignabilityOptions& options, int headings = 1);

/// The score with its directions turned into `map`.
Alignability in_map(Alignability score, const Eigen::Matrix3d& R_map_base, const Eigen::Matrix3d& R_base_scan);

/// What the scans taken in a cell say of it, their directions in `map` (Castellano-Quero et al., Eq. 2). Without scans all is NaN but
/// `samples`, which is 0.
CellValue summary(const std::vector<Alignability>& scores, const AlignabilityOptions& options);

/// The same of scans taken at several headings, a list each: what there is to say of the heading at which α is lowest, the first of them,
/// then α at each, NaN where no scan could be taken. Of one heading its summary alone.
CellValue summary(const std::vector<std::vector<Alignability>>& scores_by_heading, const AlignabilityOptions& options);

}  // namespace alignability::detail
