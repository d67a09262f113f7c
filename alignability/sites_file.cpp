// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/sites_file.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/yaml_map.hpp"

namespace alignability {
namespace {

constexpr std::pair<const char*, bool> kYesOrNo[]{{"false", false}, {"true", true}};
constexpr std::pair<const char*, SdfGeometry> kGeometries[]{{"collision", SdfGeometry::collision}, {"visual", SdfGeometry::visual}};
constexpr std::pair<const char*, UpAxis> kUpAxes[]{{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}};
constexpr std::pair<const char*, Engine> kEngines[]{{"native", Engine::native}, {"pcl", Engine::pcl}};

template <typename T>
void replace(T& value, std::optional<T> found) {
  if (found) value = *std::move(found);
}

template <typename T>
void replace(std::optional<T>& value, std::optional<T> found) {
  if (found) value = std::move(found);
}

void replace(int& value, std::optional<std::int64_t> found) {
  if (found) value = static_cast<int>(*found);
}

void read_reading(YamlMap& yaml, SiteOptions& reading) {
  if (const auto folders = yaml.find_texts("model_path")) {
    reading.world.model_paths.clear();
    for (const std::string& folder : *folders) reading.world.model_paths.push_back(yaml.file().parent_path() / folder);
  }
  replace(reading.world.geometry, yaml.find_choice("geometry", kGeometries));
  replace(reading.unit, yaml.find_number("unit", kPositive));
  replace(reading.up_axis, yaml.find_choice("up", kUpAxes));
  replace(reading.discs.thinning, yaml.find_number("thin", kPositive));
  replace(reading.level, yaml.find_choice("level", kYesOrNo));
}

std::vector<Reading> readings_named(const YamlMap& yaml, const std::vector<std::string>& names) {
  std::vector<Reading> readings;
  for (const Reading reading : {Reading::centred, Reading::voxel, Reading::robust, Reading::information}) {
    if (std::ranges::find(names, to_string(reading)) != names.end()) readings.push_back(reading);
  }
  if (readings.size() != names.size()) yaml.fail("readings", "'readings' must be of: centred, voxel, robust, information, each once");
  return readings;
}

void read_scoring(YamlMap& yaml, AlignabilityOptions& options) {
  replace(options.segmentation.engine, yaml.find_choice("engine", kEngines));
  replace(options.segmentation.stride, yaml.find_integer("stride", 1, kMostStride));
  if (const auto centred = yaml.find_choice("centred", kYesOrNo)) options.moment = *centred ? Moment::about_mean : Moment::about_origin;
  if (const auto names = yaml.find_texts("readings")) options.readings = readings_named(yaml, *names);
}

// What may stand above all sites as in each.
void read_shared(YamlMap& yaml, MapSite& site) {
  replace(site.scene, yaml.find_path("scene"));
  replace(site.occupancy, yaml.find_path("occupancy"));
  replace(site.sensor, yaml.find_path("sensor"));
  replace(site.map.resolution, yaml.find_number("resolution", kPositive));
  replace(site.map.samples, yaml.find_integer("samples", 1, 100000));
  replace(site.map.range_max, yaml.find_number("range_max", kPositive));
  if (const auto headings = yaml.find_integer("headings", 1, 360)) site.headings = static_cast<int>(*headings);
  replace(site.map.floor, yaml.find_number("floor", kFinite));
  if (const auto seed = yaml.find_integer("seed", 0, std::numeric_limits<std::int64_t>::max())) {
    site.map.seed = static_cast<std::uint64_t>(*seed);
  }
  read_reading(yaml, site.reading);
  read_scoring(yaml, site.map.alignability);
}

MapSite read_site_entry(YamlMap yaml, MapSite site) {
  site.name = yaml.text("name");
  if (site.name.empty()) yaml.fail("name", "'name' must not be empty");
  read_shared(yaml, site);
  site.output = yaml.find_path("output").value_or(yaml.file().parent_path() / site.name);
  yaml.finish();
  for (const auto& [key, file] : {std::pair("scene", &site.scene), {"occupancy", &site.occupancy}, {"sensor", &site.sensor}}) {
    if (file->empty()) yaml.fail(key, "the site has no '" + std::string(key) + "', nor is there one for all sites");
  }
  return site;
}

void refuse_twins(const YamlMap& yaml, const MapSite& site, const std::vector<MapSite>& before) {
  for (const MapSite& other : before) {
    if (other.name == site.name) yaml.fail("name", "there is another site of the name '" + site.name + "'");
    if (other.output.lexically_normal() == site.output.lexically_normal()) {
      yaml.fail("output", "the sites '" + other.name + "' and '" + site.name + "' have the same output");
    }
  }
}

// A map is written as NAME.yaml, beside what it is made of if so asked, but not over it.
void refuse_to_overwrite(const YamlMap& yaml, const MapSite& site, const std::vector<MapSite>& sites) {
  const std::filesystem::path written = std::filesystem::path(site.output.string() + ".yaml").lexically_normal();
  for (const MapSite& other : sites) {
    for (const std::filesystem::path& input : {other.occupancy, other.sensor}) {
      if (input.lexically_normal() == written) yaml.fail("output", "the map would be written over " + input.string());
    }
  }
}

}  // namespace

std::vector<MapSite> read_sites_file(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  MapSite shared;
  read_shared(yaml, shared);
  const auto entries = yaml.find_maps("sites");
  yaml.finish();
  if (!entries || entries->empty()) yaml.fail("sites", "'sites' must list at least one site");
  std::vector<MapSite> sites;
  for (const YamlMap& entry : *entries) {
    MapSite site = read_site_entry(entry, shared);
    refuse_twins(entry, site, sites);
    sites.push_back(std::move(site));
  }
  for (std::size_t i = 0; i < sites.size(); ++i) refuse_to_overwrite((*entries)[i], sites[i], sites);
  return sites;
}

}  // namespace alignability
