// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sensor_rig.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/file.hpp"
#include "core/pose.hpp"
#include "lidar/lidar_reader.hpp"

namespace alignability {
namespace {

constexpr std::size_t kMostLidars = 16;
constexpr double kBlind = radians(1.0);

double widest_step(const SensorRig& rig) {
  double step = 0.0;
  for (const LidarModel& lidar : rig.lidars) {
    for (const AzimuthSector& sector : lidar.sectors) {
      const int steps = sector.full_circle() ? sector.columns : sector.columns - 1;
      if (steps > 0) step = std::max(step, (sector.max - sector.min) / steps);
    }
  }
  return step;
}

std::vector<float> azimuths_in_base(const SensorRig& rig) {
  std::vector<float> azimuths;
  for (const LidarModel& lidar : rig.lidars) {
    const Eigen::Matrix3f R_base_lidar = lidar.T_base_lidar.linear().cast<float>();
    for (const Eigen::Vector3f& direction : beam_directions(lidar)) {
      const Eigen::Vector3f in_base = R_base_lidar * direction;
      azimuths.push_back(std::atan2(in_base.y(), in_base.x()));
    }
  }
  return azimuths;
}

}  // namespace

SensorRig::SensorRig(LidarModel lidar) : name(lidar.name), yaml(lidar.yaml) { lidars.push_back(std::move(lidar)); }

double SensorRig::range_min() const { return std::ranges::min(lidars, {}, &LidarModel::range_min).range_min; }

double SensorRig::range_stddev() const { return std::ranges::max(lidars, {}, &LidarModel::range_stddev).range_stddev; }

std::size_t SensorRig::beams() const {
  std::size_t sum = 0;
  for (const LidarModel& lidar : lidars) sum += static_cast<std::size_t>(lidar.rings()) * static_cast<std::size_t>(lidar.columns());
  return sum;
}

bool SensorRig::sees_all_around() const {
  std::vector<float> azimuths = azimuths_in_base(*this);
  std::ranges::sort(azimuths);
  double gap = 2.0 * std::numbers::pi - (azimuths.back() - azimuths.front());
  for (std::size_t i = 1; i < azimuths.size(); ++i) gap = std::max(gap, static_cast<double>(azimuths[i] - azimuths[i - 1]));
  return gap <= std::max(kBlind, 2.0 * widest_step(*this));
}

Eigen::Isometry3d SensorRig::T_base_scan() const {
  return lidars.size() == 1 ? lidars.front().T_base_lidar : Eigen::Isometry3d::Identity();
}

SensorRig read_sensor_rig(const std::filesystem::path& file) { return parse_sensor_rig(read_file(file, YamlMap::kLargestFile), file); }

SensorRig parse_sensor_rig(const std::string& yaml, const std::filesystem::path& file) {
  YamlMap map = YamlMap::from_text(yaml, file);
  if (!map.has("lidars")) return parse_lidar_model(yaml, file);
  SensorRig rig;
  rig.yaml = yaml;
  rig.name = map.text("name");
  const std::vector<YamlMap> entries = *map.find_maps("lidars");
  map.finish();
  if (entries.empty() || entries.size() > kMostLidars) {
    map.fail("lidars", "'lidars' must list from 1 to " + std::to_string(kMostLidars) + " lidars");
  }
  for (const YamlMap& entry : entries) {
    LidarModel lidar = detail::read_lidar(entry);
    if (!rig.lidars.empty()) {
      if (lidar.rate != rig.rate()) entry.fail("rate", "'rate' must be that of the first lidar, " + to_text(rig.rate()));
      if (lidar.is_planar() != rig.is_planar()) {
        entry.fail("name", "of lidars scored together all see in 2D, by one level ring, or none");
      }
    }
    rig.lidars.push_back(std::move(lidar));
  }
  return rig;
}

}  // namespace alignability
