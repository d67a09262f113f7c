// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/cost_mask.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/file.hpp"
#include "costmap/map_server_text.hpp"

namespace alignability {
namespace {

// The shade of which nav2 makes that percentage.
char shade_of(double share) {
  if (std::isnan(share)) return 0;
  if (!(share >= 0.0 && share <= 1.0)) throw std::invalid_argument("the share of a mask must be from 0 to 1");
  const double percent = std::round(kMostOfMask * share);
  return static_cast<char>(static_cast<unsigned char>(std::round(255.0 * (1.0 - percent / 100.0))));
}

}  // namespace

void write_cost_mask(const Grid<double>& share, const std::filesystem::path& name) {
  const GridGeometry& geometry = share.geometry();
  std::string pgm = detail::pgm_header(geometry);
  for (int y = geometry.height - 1; y >= 0; --y) {
    for (int x = 0; x < geometry.width; ++x) pgm += shade_of(share[Cell{x, y}]);
  }
  const std::filesystem::path image(name.string() + ".pgm");
  write_file(image, pgm);
  // Thresholds at the ends: what lies beyond one would be all or nothing.
  write_file(name.string() + ".yaml", detail::map_yaml(geometry, image.filename(), "scale", "1.0", "0.0"));
}

}  // namespace alignability
