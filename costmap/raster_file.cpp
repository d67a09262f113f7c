// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/raster_file.hpp"

#include <limits>

#include "core/input_error.hpp"
#include "costmap/alignability_map.hpp"
#include "costmap/float_tiff.hpp"
#include "costmap/map_server.hpp"

namespace alignability {
namespace {

Grid<float> read_tiff(const std::filesystem::path& file, const RasterPlace& place) {
  GridGeometry geometry = detail::pixels_of_tiff(file);
  geometry.resolution = place.resolution;
  geometry.origin = place.origin;
  return detail::read_float_tiff(file, geometry, 1).front();
}

Grid<float> read_layer(const std::filesystem::path& file, const std::string& name) {
  const AlignabilityMap map = read_alignability_map(file);
  if (const Grid<float>* layer = map.find_layer(name)) return *layer;
  std::vector<std::string> names;
  for (const AlignabilityMap::Layer& layer : map.layers) names.push_back(layer.name);
  throw InputError(file, "has no layer '" + name + "'" + did_you_mean(name, names));
}

Grid<float> read_map_server(const std::filesystem::path& file) {
  const OccupancyMap map = read_occupancy_map(file);
  Grid<float> values(map.geometry(), 0.0f);
  for (std::size_t i = 0; i < values.values().size(); ++i) {
    values[i] = map.occupancy(map.geometry().cell_of(i)).value_or(std::numeric_limits<float>::quiet_NaN());
  }
  return values;
}

}  // namespace

Grid<float> read_raster(const RasterFile& raster) {
  if (raster.place) return read_tiff(raster.file, *raster.place);
  return raster.layer.empty() ? read_map_server(raster.file) : read_layer(raster.file, raster.layer);
}

}  // namespace alignability
