// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/lidar_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/file.hpp"
#include "core/pose.hpp"
#include "lidar/lidar_reader.hpp"

namespace alignability {
namespace {

constexpr std::int64_t kMostRings = 1024;
constexpr std::int64_t kMostBeams = std::int64_t{1} << 22;
constexpr double kLongestRange = 1e4;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kAngleTolerance = 1e-9;
constexpr double kLevel = radians(1.0);
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

// rings_deg: [[elevation, azimuth offset], …].
void read_ring_table(YamlMap& map, LidarModel& model) {
  if (map.has("elevation_deg")) map.fail("rings_deg", "'rings_deg' stands in place of 'elevation_deg'; give one of them");
  const auto table = *map.find_points("rings_deg", kAzimuth);
  if (table.empty() || static_cast<std::int64_t>(table.size()) > kMostRings) {
    map.fail("rings_deg", "'rings_deg' must list from 1 to " + std::to_string(kMostRings) + " rings [elevation, azimuth offset]");
  }
  for (const Eigen::Vector2d& ring : table) {
    if (!kElevation.contains(ring.x())) {
      map.fail("rings_deg", "an elevation of 'rings_deg' must be " + kElevation.description() + ", not " + to_text(ring.x()));
    }
    model.elevations.push_back(radians(ring.x()));
    model.azimuth_offsets.push_back(radians(ring.y()));
  }
}

void read_rings(YamlMap& map, LidarModel& model) {
  if (map.has("rings_deg")) return read_ring_table(map, model);
  for (const double angle : read_elevations_deg(map)) model.elevations.push_back(radians(angle));
}

void read_azimuth(YamlMap& map, LidarModel& model) {
  const bool several = map.is_sequence("azimuth_deg");
  const std::vector<YamlMap> sectors = several ? *map.find_maps("azimuth_deg") : std::vector{map.map("azimuth_deg")};
  if (sectors.empty()) map.fail("azimuth_deg", "'azimuth_deg' must list at least one sector");
  std::int64_t columns_left = kMostBeams / model.rings();
  std::optional<double> first, last;
  for (const YamlMap& sector : sectors) {
    if (columns_left < 1)
      map.fail("azimuth_deg", "'azimuth_deg' must have at most " + std::to_string(kMostBeams) + " beams, all rings together");
    const Span span = read_span(sector, kAzimuth, columns_left);
    if (last && !(span.min > *last)) sector.fail("min", "'min' must be greater than the 'max' of the sector before, " + to_text(*last));
    if (!first) first = span.min;
    const double around = span.max - *first;
    if (around > 360.0) map.fail("azimuth_deg", "'azimuth_deg' must span at most 360 degrees");
    if (last && around == 360.0) sector.fail("max", "'max' must be less than a turn from the first 'min', " + to_text(*first));
    last = span.max;
    columns_left -= span.count;
    model.sectors.push_back({radians(span.min), radians(span.max), static_cast<int>(span.count)});
  }
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

std::vector<double> azimuths_of(const LidarModel& model) {
  std::vector<double> azimuths;
  for (const AzimuthSector& sector : model.sectors) {
    const int intervals = sector.full_circle() ? sector.columns : sector.columns - 1;
    for (int column = 0; column < sector.columns; ++column) {
      const double share = intervals == 0 ? 0.0 : static_cast<double>(column) / intervals;
      azimuths.push_back(std::lerp(sector.min, sector.max, share));
    }
  }
  return azimuths;
}

std::vector<Eigen::Vector2d> headings_of(const std::vector<double>& azimuths, double offset) {
  std::vector<Eigen::Vector2d> headings;
  for (const double azimuth : azimuths) headings.emplace_back(std::cos(azimuth + offset), std::sin(azimuth + offset));
  return headings;
}

}  // namespace

bool AzimuthSector::full_circle() const { return max - min >= kFullTurn - kAngleTolerance; }

int LidarModel::columns() const {
  int sum = 0;
  for (const AzimuthSector& sector : sectors) sum += sector.columns;
  return sum;
}

bool LidarModel::full_circle() const { return sectors.size() == 1 && sectors.front().full_circle(); }

bool LidarModel::is_planar() const {
  if (rings() != 1) return false;
  const double tilt = std::acos(std::min(1.0, std::abs(T_base_lidar.linear()(2, 2))));
  return tilt + std::abs(elevations.front()) <= kLevel;
}

std::vector<Eigen::Vector3f> beam_directions(const LidarModel& model) {
  const std::vector<double> azimuths = azimuths_of(model);
  std::vector<Eigen::Vector2d> headings = headings_of(azimuths, 0.0);
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(model.elevations.size() * azimuths.size());
  for (std::size_t ring = 0; ring < model.elevations.size(); ++ring) {
    const double level = std::cos(model.elevations[ring]);
    const double up = std::sin(model.elevations[ring]);
    if (!model.azimuth_offsets.empty()) headings = headings_of(azimuths, model.azimuth_offsets[ring]);
    for (const Eigen::Vector2d& heading : headings) {
      directions.push_back(Eigen::Vector3d(level * heading.x(), level * heading.y(), up).cast<float>());
    }
  }
  return directions;
}

LidarModel read_lidar_model(const std::filesystem::path& file) { return parse_lidar_model(read_file(file, YamlMap::kLargestFile), file); }

LidarModel parse_lidar_model(const std::string& yaml, const std::filesystem::path& file) {
  YamlMap map = YamlMap::from_text(yaml, file);
  if (map.has("lidars")) map.fail("lidars", "several lidars are not taken here; give the file of one");
  LidarModel model = detail::read_lidar(std::move(map));
  model.yaml = yaml;
  return model;
}

LidarModel detail::read_lidar(YamlMap map) {
  LidarModel model;
  model.name = map.text("name");
  read_rings(map, model);
  read_azimuth(map, model);
  read_range(map.map("range"), model);
  model.rate = map.number("rate", kRate);
  if (const auto mount = map.find_map("mount")) model.T_base_lidar = read_mount(*mount);
  map.finish();
  return model;
}

}  // namespace alignability
