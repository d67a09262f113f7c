// SPDX-License-Identifier: BSD-3-Clause
#include "planner/station_file.hpp"

#include "core/yaml_map.hpp"

namespace alignability {

std::vector<Station> read_station_file(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  YamlMap named = yaml.map("stations");
  yaml.finish();
  std::vector<Station> stations;
  for (const std::string& name : named.keys()) {
    const std::vector<double> pose = named.numbers(name, 3, kFinite);
    stations.push_back({name, {pose[0], pose[1], pose[2]}});
  }
  if (stations.size() < 2) yaml.fail("stations", "there must be at least two stations");
  return stations;
}

}  // namespace alignability
