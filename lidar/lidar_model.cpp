// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/lidar_model.hpp"

#include <cmath>
#include <numbers>

#include "core/file.hpp"
#include "core/pose.hpp"
#include "core/yaml_map.hpp"

namespace alignability {
namespace {

constexpr std::int64_t kMostRings = 1024;
constexpr std::int64_t kMostBeams = std::int64_t{1} << 22;
constexpr double kLongestRange = 1e4;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kAngleTolerance = 1e-9;
constexpr Range kElevation{.min = -90.0, .max = 90.0};
constexpr Range kAzimuth{.min = -360.0, .max = 360.0};
constexpr Range kRate{.min = 0.0, .max = 1e6, .min_end = Range::End::open};

// `count` numbers from `min` to `max`, both included.
std::vector<double> evenly_spaced(double min, double max, std::int64_t count) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < count; ++i) values.push_back(count == 1 ? min : std::lerp(min, max, static_cast<double>(i) / (count - 1)));
  return values;
}

struct Span {
  double min;
  double max;
  std::int64_t count;
};

// {min: …, max: …, count: …}, where one value needs min and max to be equal and more need them to differ.
Span read_span(YamlMap map, const Range& allowed, std::int64_t most) {
  const Span span{map.number("min", allowed), map.number("max", allowed), map.integer("count", 1, most)};
  map.finish();
  if (span.count == 1 && span.min != span.max) map.fail("count", "'count' of 1 needs 'min' and 'max' to be equal");
  if (span.count > 1 && !(span.min < span.max)) map.fail("max", "'max' must be greater than 'min', which is " + to_text(span.min));
  return span;
}

std::vector<double> read_elevations_deg(YamlMap& map) {
  if (map.is_sequence("elevation_deg")) {
    const auto list = *map.find_numbers("elevation_deg", kElevation);
    if (list.empty() || static_cast<std::int64_t>(list.size()) > kMostRings) {
      map.fail("elevation_deg", "'elevation_deg' must list from 1 to " + std::to_string(kMostRings) + " angles");
    }
    return list;
  }
  const Span span = read_span(map.map("elevation_deg"), kElevation, kMostRings);
  return evenly_spaced(span.min, span.max, span.count);
}

void read_azimuth(YamlMap& map, LidarModel& model) {
  const Span span = read_span(map.map("azimuth_deg"), kAzimuth, kMostBeams / model.rings());
  if (span.max - span.min > 360.0) map.fail("azimuth_deg", "'azimuth_deg' must span at most 360 degrees");
  model.azimuth_min = radians(span.min);
  model.azimuth_max = radians(span.max);
  model.columns = static_cast<int>(span.count);
}

void read_range(YamlMap map, LidarModel& model) {
  model.range_min = map.number("min", {.min = 0.0, .max = kLongestRange});
  model.range_max = map.number("max", {.min = model.range_min, .max = kLongestRange, .min_end = Range::End::open});
  model.range_stddev = map.number("stddev", {.min = 0.0, .max = kLongestRange});
  map.finish();
}

Eigen::Isometry3d read_mount(YamlMap map) {
  const std::vector<double> xyz = map.numbers("xyz", 3, kFinite);
  const std::vector<double> rpy = map.numbers("rpy_deg", 3, kFinite);
  map.finish();
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() =
      (Eigen::AngleAxisd(radians(rpy[2]), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(radians(rpy[1]), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(radians(rpy[0]), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  mount.translation() = Eigen::Vector3d(xyz[0], xyz[1], xyz[2]);
  return mount;
}

}  // namespace

bool LidarModel::full_circle() const { return azimuth_max - azimuth_min >= kFullTurn - kAngleTolerance; }

std::vector<Eigen::Vector3f> beam_directions(const LidarModel& model) {
  const int intervals = model.full_circle() ? model.columns : model.columns - 1;
  std::vector<Eigen::Vector2d> headings;
  for (int column = 0; column < model.columns; ++column) {
    const double share = intervals == 0 ? 0.0 : static_cast<double>(column) / intervals;
    const double azimuth = std::lerp(model.azimuth_min, model.azimuth_max, share);
    headings.emplace_back(std::cos(azimuth), std::sin(azimuth));
  }
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(model.elevations.size() * headings.size());
  for (const double elevation : model.elevations) {
    const double level = std::cos(elevation);
    const double up = std::sin(elevation);
    for (const Eigen::Vector2d& heading : headings) {
      directions.push_back(Eigen::Vector3d(level * heading.x(), level * heading.y(), up).cast<float>());
    }
  }
  return directions;
}

LidarModel read_lidar_model(const std::filesystem::path& file) { return parse_lidar_model(read_file(file, YamlMap::kLargestFile), file); }

LidarModel parse_lidar_model(const std::string& yaml, const std::filesystem::path& file) {
  YamlMap map = YamlMap::from_text(yaml, file);
  LidarModel model;
  model.yaml = yaml;
  model.name = map.text("name");
  for (const double angle : read_elevations_deg(map)) model.elevations.push_back(radians(angle));
  read_azimuth(map, model);
  read_range(map.map("range"), model);
  model.rate = map.number("rate", kRate);
  if (const auto mount = map.find_map("mount")) model.T_base_lidar = read_mount(*mount);
  map.finish();
  return model;
}

}  // namespace alignability
