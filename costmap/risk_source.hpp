// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "costmap/occupancy_map.hpp"
#include "costmap/raster_file.hpp"

namespace alignability {

/// What a place is worth where nobody knows.
enum class UnknownPolicy {
  risky,    ///< risk 1, and blind
  neutral,  ///< risk 0, and not blind
  blocked,  ///< not drivable; risk 1 where asked all the same; of alignability alone
};

/// The name of a policy as problem files have it.
const char* to_string(UnknownPolicy policy);

/// A kind of risk beside that of poor alignability: a value by place, such as how often something moves there, and from where to where it
/// is risky. As with α, cells without a value take that of their neighbours first (see fill_border), and `unknown` says of the others.
struct RiskSource {
  std::string name = {};                           ///< see is_source_name; another than kAlignability and than other sources'
  double weight = 1.0;                             ///< what it counts in the sum of risks, >= 0
  double risky = 1.0;                              ///< the value from which on the risk is 1
  double safe = 0.0;                               ///< that from which on it is 0, on whichever side; linear between
  UnknownPolicy unknown = UnknownPolicy::risky;    ///< not `blocked`
  std::optional<RasterFile> file = {};             ///< that the values are from, for the record
  std::shared_ptr<const Grid<float>> values = {};  ///< finite or NaN, at the centres of cells that cover the occupancy map
};

/// The name that α's own risk has among the sources, and that of the risk which problem files give by clearance.
inline constexpr const char* kAlignability = "alignability";
inline constexpr const char* kClearance = "clearance";

/// The clearance [m] at the corners of the map's cells: as the centres of cells that begin half a cell before the map's.
Grid<float> clearance_values(const OccupancyMap& occupancy);

/// Whether one grid has cells wherever the other has, to a millionth of a cell.
bool covers(const GridGeometry& grid, const GridGeometry& other);

/// Whether it is made of letters, digits, '_' and '-'.
bool is_source_name(const std::string& name);

/// What is wrong with a source on a map; nullopt when nothing is. O(cells).
std::optional<std::string> fault_of_source(const RiskSource& source, const GridGeometry& map);

/// 1 at `risky` and beyond, 0 at `safe` and beyond, linear between; of NaN what the policy says.
double risk_of(double value, double risky, double safe, UnknownPolicy unknown);

}  // namespace alignability
