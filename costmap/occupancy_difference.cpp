// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/occupancy_difference.hpp"

#include <stdexcept>

namespace alignability {
namespace {

enum class State { unknown, free, occupied };

State state_of(const OccupancyMap& map, Cell cell) {
  if (!map.occupancy(cell)) return State::unknown;
  return map.is_free(cell) ? State::free : State::occupied;
}

// In the cell itself or one of the eight around it.
bool has_nearby(const OccupancyMap& map, Cell cell, State state) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (map.geometry().contains({x, y}) && state_of(map, {x, y}) == state) return true;
    }
  }
  return false;
}

CellAgreement agreement_in(const OccupancyMap& first, const OccupancyMap& second, Cell cell) {
  const State in_first = state_of(first, cell);
  const State in_second = state_of(second, cell);
  if (in_first == State::unknown || in_second == State::unknown) return CellAgreement::not_compared;
  if (in_first == in_second) return in_first == State::free ? CellAgreement::both_free : CellAgreement::both_occupied;
  if (has_nearby(first, cell, in_second) && has_nearby(second, cell, in_first)) return CellAgreement::within_a_cell;
  return in_first == State::occupied ? CellAgreement::occupied_in_first : CellAgreement::occupied_in_second;
}

}  // namespace

OccupancyDifference occupancy_difference(const OccupancyMap& first, const OccupancyMap& second) {
  const GridGeometry& geometry = first.geometry();
  if (geometry != second.geometry()) throw std::invalid_argument("maps that are compared must have the same cells");
  OccupancyDifference result{.cells = Grid<CellAgreement>(geometry, CellAgreement::not_compared)};
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const CellAgreement agreement = agreement_in(first, second, geometry.cell_of(i));
    result.cells[i] = agreement;
    result.compared += agreement == CellAgreement::not_compared ? 0 : 1;
    result.differing += agreement == CellAgreement::occupied_in_first || agreement == CellAgreement::occupied_in_second ? 1 : 0;
  }
  return result;
}

}  // namespace alignability
