// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace alignability {

/// Where each value would stand in ascending order, from 0; equal values share the mean of their places.
std::vector<double> ranks_of(std::span<const double> values);

/// Spearman's rank correlation of pairs, in [-1,1]; NaN for fewer than two pairs and where all values of one side are equal. Values must
/// not be NaN. O(n log n). Throws std::invalid_argument unless both sides have as many.
double rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace alignability
