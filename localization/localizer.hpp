// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "lidar/sensor_rig.hpp"
#include "localization/ndt_mcl.hpp"
#include "localization/scan_matcher.hpp"

namespace alignability {

enum class Localizer {
  ndt_mcl_sum,      ///< NDT-MCL as published
  ndt_mcl_product,  ///< NDT-MCL with the product of its cells' matches
  scan_matching,    ///< point-to-plane matching, fused with odometry
};

/// Their names on the command line and in files.
inline constexpr std::pair<const char*, Localizer> kLocalizers[] = {
    {"ndt_mcl_sum", Localizer::ndt_mcl_sum}, {"ndt_mcl_product", Localizer::ndt_mcl_product}, {"scan_matching", Localizer::scan_matching}};
const char* to_string(Localizer localizer);
std::optional<Localizer> localizer_named(std::string_view name);
/// What is wrong with a name that none has.
std::string refusal_of_localizer(const std::string& name);

struct LocalizerOptions {
  NdtOptions ndt = {};         ///< of the map and of scans
  NdtMclOptions ndt_mcl = {};  ///< but for the combination, which the localizer's name tells
  ScanMatcherOptions scan_matcher = {};
  Pose2 start_deviations{0.1, 0.1, radians(1)};  ///< standard deviations of what is known of the start
};

/// The options for what a sensor sees. Of level lidars, which see the world in plan, cells are squares, nothing is taken for the floor, and
/// the lines of the map for upright planes.
LocalizerOptions for_sensor(LocalizerOptions options, const SensorRig& sensor);

/// The map that localizers hold, as each of them reads it.
struct LocalizationMap {
  /// Of a cloud in `map`, z from the floor, for these localizers. Throws std::invalid_argument for options out of range.
  LocalizationMap(std::span<const Eigen::Vector3f> cloud, const LocalizerOptions& options, std::span<const Localizer> localizers);

  std::shared_ptr<const Ndt> ndt;          ///< nullptr where none of them needs it
  std::shared_ptr<const PlaneMap> planes;  ///< likewise
};

/// One of them at work. Not for several threads.
class RunningLocalizer {
 public:
  /// On a map made for it. Throws std::invalid_argument for options out of range.
  RunningLocalizer(Localizer localizer, const LocalizationMap& map, const Pose2& start, const LocalizerOptions& options,
                   std::uint64_t seed);

  /// Takes the motion that odometry reports, from the last pose's frame.
  void move(const Pose2& motion);
  /// Takes what the lidar sees: points in the frame of `base_link`, and the same as an NDT.
  void see(std::span<const Eigen::Vector3f> points, const Ndt& ndt);
  Pose2 estimate() const;

 private:
  std::variant<NdtMcl, ScanMatcher> localizer_;
};

}  // namespace alignability
