// SPDX-License-Identifier: BSD-3-Clause
#include "localization/drive_file.hpp"

#include "core/yaml_map.hpp"

namespace alignability {
namespace {

OdometryError read_odometry(YamlMap yaml) {
  OdometryError error;
  constexpr Range kBias{.min = -0.5, .max = 0.5};
  error.scale_bias = yaml.find_number("scale_bias", kBias).value_or(error.scale_bias);
  error.heading_bias = radians(yaml.find_number("heading_bias_deg", kFinite).value_or(0.0));
  error.position_noise = yaml.find_number("position_noise", kNotNegative).value_or(error.position_noise);
  error.heading_noise = radians(yaml.find_number("heading_noise_deg", kNotNegative).value_or(0.0));
  error.turning_noise = radians(yaml.find_number("turning_noise_deg", kNotNegative).value_or(0.0));
  yaml.finish();
  return error;
}

Pose2 read_deviations(YamlMap& yaml, std::string_view key, const Pose2& otherwise) {
  const auto values = yaml.find_numbers(key, 3, kNotNegative);
  return values ? Pose2{(*values)[0], (*values)[1], (*values)[2]} : otherwise;
}

MotionNoise read_motion_noise(YamlMap yaml) {
  MotionNoise noise;
  noise.per_metre = read_deviations(yaml, "per_metre", noise.per_metre);
  noise.per_radian = read_deviations(yaml, "per_radian", noise.per_radian);
  yaml.finish();
  return noise;
}

Pose2 read_start_deviations(YamlMap yaml, Pose2 deviations) {
  deviations.x = deviations.y = yaml.find_number("position", kNotNegative).value_or(deviations.x);
  if (const auto heading = yaml.find_number("heading_deg", kNotNegative)) deviations.yaw = radians(*heading);
  yaml.finish();
  return deviations;
}

Regularization read_regularization(YamlMap yaml, double resample_below) {
  Regularization regularization;
  const Range effective{.min = 0.0, .max = resample_below, .min_end = Range::End::open, .max_end = Range::End::open};
  regularization.least_effective = yaml.find_number("least_effective", effective).value_or(regularization.least_effective);
  regularization.bandwidths = yaml.find_number("bandwidths", kShare).value_or(regularization.bandwidths);
  yaml.finish();
  return regularization;
}

std::vector<Localizer> read_localizers(YamlMap& yaml, const std::vector<std::string>& names) {
  std::vector<Localizer> localizers;
  for (const std::string& name : names) {
    const auto localizer = localizer_named(name);
    if (!localizer) yaml.fail("localizers", refusal_of_localizer(name));
    localizers.push_back(*localizer);
  }
  if (localizers.empty()) yaml.fail("localizers", "name at least one localizer");
  return localizers;
}

}  // namespace

DriveOptions read_drive_file(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  DriveOptions options;
  options.pace.speed = yaml.find_number("speed", kPositive).value_or(options.pace.speed);
  if (const auto rate = yaml.find_number("turn_rate_deg", kPositive)) options.pace.turn_rate = radians(*rate);
  if (const auto odometry = yaml.find_map("odometry")) options.odometry = read_odometry(*odometry);
  if (const auto names = yaml.find_texts("localizers")) options.localizers = read_localizers(yaml, *names);
  LocalizerOptions& localizer = options.localizer;
  localizer.ndt_mcl.particles = static_cast<int>(yaml.find_integer("particles", 1, 1'000'000).value_or(localizer.ndt_mcl.particles));
  if (const auto regularization = yaml.find_map("regularization")) {
    localizer.ndt_mcl.regularization = read_regularization(*regularization, localizer.ndt_mcl.resample_below);
  }
  localizer.ndt.cell = yaml.find_number("cell", kPositive).value_or(localizer.ndt.cell);
  if (const auto noise = yaml.find_map("motion_noise")) {
    localizer.ndt_mcl.noise = localizer.scan_matcher.noise = read_motion_noise(*noise);
  }
  if (const auto deviations = yaml.find_map("start_deviations")) {
    localizer.start_deviations = read_start_deviations(*deviations, localizer.start_deviations);
  }
  yaml.finish();
  return options;
}

}  // namespace alignability
