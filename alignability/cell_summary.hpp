// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "alignability/alignability.hpp"

namespace alignability::detail {

/// What a map says of a cell, layer by layer; NaN where there is nothing to say.
using CellValue = std::vector<float>;

/// The layers of a map made with such options: alpha, samples, iqr, weak_x, weak_y, weak_z, then those of the readings.
std::vector<std::string> layer_names(const AlignabilityOptions& options);

/// The score with its directions turned into `map`.
Alignability in_map(Alignability score, const Eigen::Matrix3d& R_map_base, const Eigen::Matrix3d& R_base_scan);

/// What the scans taken in a cell say of it, their directions in `map` (Castellano-Quero et al., Eq. 2). Without scans all is NaN but
/// `samples`, which is 0.
CellValue summary(const std::vector<Alignability>& scores, const AlignabilityOptions& options);

}  // namespace alignability::detail
