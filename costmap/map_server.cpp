// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/map_server.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>

#include "core/file.hpp"
#include "core/yaml_map.hpp"
#include "costmap/grey_image.hpp"
#include "costmap/map_server_text.hpp"

namespace alignability {
namespace {

enum class MapMode { trinary, scale, raw };

constexpr float kFree = 0.0f;
constexpr float kOccupied = 1.0f;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

// What the YAML says of how shades become occupancy.
struct Interpretation {
  MapMode mode = MapMode::trinary;
  bool negate = false;
  double occupied_thresh = 0.0;
  double free_thresh = 0.0;

  float occupancy(const detail::GreyImage& image, int x, int row) const {
    switch (mode) {
      case MapMode::raw:
        return raw(image.shade(x, row));
      case MapMode::scale:
        return image.opaque(x, row) ? scaled(darkness(image.shade(x, row))) : kUnknown;
      case MapMode::trinary:
        return trinary(darkness(image.shade_with_alpha(x, row)));
    }
    return kUnknown;
  }

 private:
  double darkness(double shade) const { return negate ? shade : 1.0 - shade; }

  float trinary(double darkness) const {
    if (occupied_thresh < darkness) return kOccupied;
    return darkness < free_thresh ? kFree : kUnknown;
  }
  float scaled(double darkness) const {
    const float clear = trinary(darkness);
    return std::isnan(clear) ? percent(std::rint(100.0 * ((darkness - free_thresh) / (occupied_thresh - free_thresh)))) : clear;
  }
  static float raw(double shade) {
    const double value = std::round(255.0 * shade);
    return value <= 100.0 ? percent(value) : kUnknown;
  }
  static float percent(double value) { return static_cast<float>(value / 100.0); }
};

bool read_negate(YamlMap& yaml) {
  constexpr std::pair<const char*, bool> kWords[] = {{"0", false}, {"1", true}, {"false", false}, {"true", true}};
  const auto negate = yaml.find_choice("negate", kWords);
  if (!negate) yaml.fail("negate", "missing key 'negate': 0 where white is free, 1 where black is");
  return *negate;
}

Interpretation read_interpretation(YamlMap& yaml) {
  constexpr std::pair<const char*, MapMode> kModes[] = {{"trinary", MapMode::trinary}, {"scale", MapMode::scale}, {"raw", MapMode::raw}};
  Interpretation result;
  result.mode = yaml.find_choice("mode", kModes).value_or(MapMode::trinary);
  result.negate = read_negate(yaml);
  result.occupied_thresh = yaml.number("occupied_thresh", kShare);
  result.free_thresh = yaml.number("free_thresh", kShare);
  if (result.free_thresh >= result.occupied_thresh) yaml.fail("free_thresh", "'free_thresh' must be less than 'occupied_thresh'");
  return result;
}

}  // namespace

OccupancyMap read_occupancy_map(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  const auto image_file = yaml.path("image");
  const double resolution = yaml.number("resolution", kPositive);
  const auto origin = yaml.numbers("origin", 3, kFinite);
  const Interpretation interpretation = read_interpretation(yaml);
  yaml.finish();
  if (origin[2] != 0.0) {
    yaml.fail("origin",
              "the origin's yaw is " + to_text(origin[2]) + "; only maps with a yaw of 0 are supported: rotate the image instead");
  }
  const detail::GreyImage image = detail::read_grey_image(image_file);
  const GridGeometry geometry{.resolution = resolution, .origin = {origin[0], origin[1]}, .width = image.width, .height = image.height};
  Grid<float> occupancy(geometry, kUnknown);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      occupancy[Cell{x, y}] = interpretation.occupancy(image, x, geometry.height - 1 - y);
    }
  }
  return OccupancyMap(std::move(occupancy));
}

namespace detail {

std::string pgm_header(const GridGeometry& geometry) {
  return "P5\n" + std::to_string(geometry.width) + ' ' + std::to_string(geometry.height) + "\n255\n";
}

std::string map_yaml(const GridGeometry& geometry, const std::filesystem::path& image, std::string_view mode,
                     std::string_view occupied_thresh, std::string_view free_thresh) {
  YAML::Emitter image_name;  // quotes what YAML would take for something else
  image_name << image.string();
  std::string text = "image: ";
  text.append(image_name.c_str()).append("\nmode: ").append(mode).append("\nresolution: ").append(to_text(geometry.resolution));
  text.append("\norigin: [")
      .append(to_text(geometry.origin.x()))
      .append(", ")
      .append(to_text(geometry.origin.y()))
      .append(", 0]\nnegate: 0");
  return text.append("\noccupied_thresh: ").append(occupied_thresh).append("\nfree_thresh: ").append(free_thresh).append("\n");
}

}  // namespace detail

void write_occupancy_map(const OccupancyMap& map, const std::filesystem::path& name) {
  const GridGeometry& geometry = map.geometry();
  const std::filesystem::path image(name.string() + ".pgm");
  std::string pgm = detail::pgm_header(geometry);
  pgm.reserve(pgm.size() + geometry.size());
  for (int y = geometry.height - 1; y >= 0; --y) {
    for (int x = 0; x < geometry.width; ++x) {
      const auto occupancy = map.occupancy({x, y});
      pgm += static_cast<char>(!occupancy ? 205 : *occupancy > OccupancyMap::kOccupiedAbove ? 0 : 254);
    }
  }
  write_file(image, pgm);
  write_file(name.string() + ".yaml", detail::map_yaml(geometry, image.filename(), "trinary", "0.65", "0.196"));
}

}  // namespace alignability
