// SPDX-License-Identifier: BSD-3-Clause
#include "cli/map_output.hpp"

#include <cstdio>
#include <iostream>

#include "cli/progress_bar.hpp"
#include "pictures/alignability_picture.hpp"

namespace alignability::cli {

void store_map(const AlignabilityMap& map, const OccupancyMap& occupancy, const std::filesystem::path& name, const PictureKinds& kinds) {
  for (const auto& file : picture_files(name, kinds)) {
    draw_alignability_map(map, occupancy, {.title = name.filename().string(), .risk = {}}, file);
  }
  write_alignability_map(map, name);
}

OccupancyMap open_ground(const GridGeometry& cells) { return OccupancyMap(Grid<float>(cells, 0.0f)); }

std::vector<std::filesystem::path> map_files(const std::filesystem::path& name, const PictureKinds& kinds) {
  std::vector<std::filesystem::path> files{with_ending(name, ".yaml"), with_ending(name, ".tiff")};
  for (const auto& file : picture_files(name, kinds)) files.push_back(file);
  return files;
}

void tell(const Json& summary, bool json) {
  if (json) return print({summary});
  const Json& alpha = summary["alpha"];
  const double seconds = summary["seconds"];
  std::cout << summary["cells_evaluated"] << " of " << summary["cells"] << " cells from " << summary["scans"] << " scans in "
            << duration_text(seconds) << '\n';
  if (!alpha["min"].is_null()) {
    std::printf("alpha: min %.3f, median %.3f, max %.3f\n", alpha["min"].get<double>(), alpha["median"].get<double>(),
                alpha["max"].get<double>());
    std::fflush(stdout);
  }
  for (const Json& file : summary["files"]) std::cout << "wrote " << file.get<std::string>() << '\n';
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace alignability::cli
