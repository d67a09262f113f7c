// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace alignability {

/// What a map says of a cell, layer by layer; NaN where there is nothing to say.
using CellValue = std::vector<float>;

/// The cells of a map that are left to evaluate, and what to do with each. Cells are numbered as the map's grid numbers them.
struct CellWork {
  std::span<const std::size_t> cells;
  /// Of any cell of the map, whether among `cells` or not: the same value on every machine. Safe to call from many threads. Throws
  /// Interrupted once `stop` is requested.
  std::function<CellValue(std::size_t cell)> evaluate;
  /// Takes a value in, and keeps it in the checkpoint if there is one. Safe to call from many threads. Throws InputError when the disk is
  /// full.
  std::function<void(std::size_t cell, const CellValue& value)> enter;
  int threads = 0;  ///< 0: one a processor
  std::stop_token stop;
};

/// Has each of the cells evaluated somewhere and its value entered here, once; what that throws ends the rest and is thrown.
using CellSpread = std::function<void(const CellWork&)>;

/// Evaluates the cells on threads of this process.
void spread_over_threads(const CellWork& work);

}  // namespace alignability
