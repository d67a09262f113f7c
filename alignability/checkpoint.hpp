// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_map>

#include "alignability/cell_evaluator.hpp"

namespace alignability::detail {

/// The cells that a build has evaluated so far, in a file that outlives it: one record a cell, written whole with its checksum, so that a
/// build killed at any moment loses at most the cells it was at. Values are kept to the bit.
class Checkpoint {
 public:
  /// Creates the file, or goes on with that of an earlier build of the same fingerprint; so many `values` a cell. Throws InputError when
  /// the file cannot be written, is none of ours, holds cells of another fingerprint, or a build that is under way has it.
  Checkpoint(std::filesystem::path file, std::uint64_t fingerprint, std::size_t values);
  ~Checkpoint();
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;

  /// By the index of the cell in the map.
  const std::unordered_map<std::size_t, CellValue>& found() const { return found_; }

  /// By one thread at a time. Throws InputError when the disk is full.
  void append(std::size_t cell, const CellValue& value);

 private:
  [[noreturn]] void fail(int error_number) const;
  void read_records(const std::string& bytes);

  std::filesystem::path file_;
  std::size_t values_;
  int descriptor_ = -1;
  std::unordered_map<std::size_t, CellValue> found_;
};

/// What the values of a map's cells depend on: surfaces, free space, sensor, options and seed, not the choice of cells.
std::uint64_t fingerprint(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor, const std::string& options,
                          std::uint64_t seed);

}  // namespace alignability::detail
