// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace alignability {

/// A cell by column (along x) and row (along y), both from 0 at the map's lower left corner; may lie outside of a grid.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

/// Where the cells of a map lie in `map`. Cell (0,0) is the lower left one, rows go up: the square of cell (x, y) is
/// [origin + resolution·(x, y), origin + resolution·(x+1, y+1)), its centre half a cell further.
struct GridGeometry {
  double resolution = 1.0;                           ///< side of a cell [m], > 0
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< outer corner of cell (0,0) in `map` [m]
  int width = 0;                                     ///< columns
  int height = 0;                                    ///< rows

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  Eigen::Vector2d extent() const { return resolution * Eigen::Vector2d(width, height); }
  Eigen::Vector2d upper_corner() const { return origin + extent(); }

  bool contains(Cell cell) const { return cell.x >= 0 && cell.x < width && cell.y >= 0 && cell.y < height; }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell.x);
  }
  Cell cell_of(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }

  Eigen::Vector2d corner(Cell cell) const { return origin + resolution * Eigen::Vector2d(cell.x, cell.y); }
  Eigen::Vector2d center(Cell cell) const { return origin + resolution * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5); }

  /// The cell that holds a point; nullopt off the map, and for NaN.
  std::optional<Cell> cell_near(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d at = (point - origin) / resolution;
    const bool inside = at.x() >= 0.0 && at.x() < width && at.y() >= 0.0 && at.y() < height;
    if (!inside) return std::nullopt;
    return Cell{static_cast<int>(at.x()), static_cast<int>(at.y())};
  }

  bool operator==(const GridGeometry&) const = default;
};

/// A value per cell, row after row from the bottom one (min y).
template <typename T>
class Grid {
 public:
  Grid() = default;
  Grid(const GridGeometry& geometry, const T& value) : Grid(geometry, std::vector<T>(geometry.size(), value)) {}
  /// Throws std::invalid_argument unless there is one value per cell.
  Grid(const GridGeometry& geometry, std::vector<T> values) : geometry_(geometry), values_(std::move(values)) {
    if (!(geometry.resolution > 0.0) || geometry.width < 0 || geometry.height < 0 || values_.size() != geometry.size()) {
      throw std::invalid_argument("a grid needs a positive resolution and one value per cell");
    }
  }

  const GridGeometry& geometry() const { return geometry_; }
  const std::vector<T>& values() const { return values_; }

  const T& operator[](Cell cell) const { return values_[geometry_.index(cell)]; }
  T& operator[](Cell cell) { return values_[geometry_.index(cell)]; }
  const T& operator[](std::size_t index) const { return values_[index]; }
  T& operator[](std::size_t index) { return values_[index]; }

 private:
  GridGeometry geometry_;
  std::vector<T> values_;
};

}  // namespace alignability
