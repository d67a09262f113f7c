// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "costmap/error_model.hpp"
#include "costmap/grid.hpp"

namespace alignability {

/// α per cell and what else was found out on the way, each a layer of the same geometry; NaN = not evaluated.
struct AlignabilityMap {
  struct Layer {
    std::string name;  ///< alpha, samples, iqr, weak_x, …: see build_alignability_map; headings: see heading_layers
    Grid<float> values;
  };

  GridGeometry geometry;
  std::vector<Layer> layers;  ///< the first is `alpha`
  std::uint64_t seed = 0;
  std::string options;                         ///< YAML text of the options it was made with
  std::string sensor;                          ///< the sensor file it was made with, verbatim
  std::string provenance;                      ///< YAML text: the files it was made from
  std::optional<ErrorModel> error_model = {};  ///< fitted to drives on this map

  const Grid<float>& alpha() const { return layers.front().values; }
  /// nullptr when there is no layer of that name.
  const Grid<float>* find_layer(std::string_view name) const;
};

/// Reads NAME.yaml and the TIFF that it names. Throws InputError.
AlignabilityMap read_alignability_map(const std::filesystem::path& yaml_file);

/// Writes NAME.yaml and NAME.tiff (32-bit float, a page a layer, the top row first, NaN marked as no data for GDAL), the YAML last.
/// `name` has no extension. Throws InputError.
void write_alignability_map(const AlignabilityMap& map, const std::filesystem::path& name);

}  // namespace alignability
