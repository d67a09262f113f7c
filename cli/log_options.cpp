// SPDX-License-Identifier: BSD-3-Clause
#include "cli/log_options.hpp"

#include <iostream>
#include <map>
#include <stdexcept>

#include "lidar/carmen_log.hpp"

namespace alignability::cli {
namespace {

const std::map<std::string, Pairing> kPairings{{"stamp", Pairing::stamp}, {"number", Pairing::number}, {"order", Pairing::order}};
const std::map<std::string, TrajectoryFrame> kFrames{{"lidar", TrajectoryFrame::lidar}, {"base_link", TrajectoryFrame::base_link}};

template <typename Value>
CLI::IsMember names_of(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return CLI::IsMember(names);
}

}  // namespace

void add_log_options(CLI::App& command, LogOptions& options) {
  command.add_option("--trajectory", options.trajectory, "Poses of the scans, TUM or KITTI, one a line; # before comments")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--pair-by", [&options](const std::string& name) { options.reading.pairing = kPairings.at(name); },
          "Pose of a scan: by the stamp or number in its name, or by order (default: stamp for TUM, number where a "
          "number stands before the stamp, order for KITTI)")
      ->check(names_of(kPairings));
  command
      .add_option_function<std::string>(
          "--poses-of", [&options](const std::string& name) { options.reading.frame = kFrames.at(name); },
          "Whose poses these are; base_link takes --sensor, for the mount")
      ->check(names_of(kFrames))
      ->default_str("lidar");
  command.add_option("--max-gap", options.reading.max_gap, "By stamp: a pose must be so near to a scan [s]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

ScanLog read_log(const LogOptions& options, const std::optional<LidarModel>& lidar) {
  if (is_carmen_log(options.folder)) {
    if (!options.trajectory.empty()) throw std::invalid_argument("--trajectory: a CARMEN log has the poses of its scans");
    return {.pairing = Pairing::none, .scans = read_carmen_log(options.folder), .without_a_pose = {}};
  }
  if (options.trajectory.empty()) throw std::invalid_argument("--trajectory is required for a folder of scans");
  ScanLogOptions reading = options.reading;
  if (reading.frame == TrajectoryFrame::base_link && !lidar) {
    throw std::invalid_argument("--poses-of base_link takes --sensor: its mount says where the lidar is");
  }
  if (lidar) reading.T_base_lidar = lidar->T_base_lidar;
  ScanLog log = read_scan_log(options.folder, read_trajectory(options.trajectory), reading);
  if (const std::size_t without = log.without_a_pose.size(); without > 0) {
    std::cerr << "warning: " << without << " of " << without + log.scans.size() << " scans have no pose and are left out, first "
              << log.without_a_pose.front().filename().string() << '\n';
  }
  return log;
}

}  // namespace alignability::cli
