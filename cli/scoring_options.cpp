// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scoring_options.hpp"

#include <algorithm>
#include <array>

namespace alignability::cli {
namespace {

constexpr std::array kReadings{Reading::centred, Reading::voxel, Reading::robust, Reading::information};

}  // namespace

void add_scoring_options(CLI::App& command, AlignabilityOptions& options) {
  SegmentationOptions& segmentation = options.segmentation;
  const auto set_engine = [&segmentation](const std::string& name) {
    segmentation.engine = name == to_string(Engine::pcl) ? Engine::pcl : Engine::native;
  };
  command.add_option_function<std::string>("--engine", set_engine, "Who segments the scans: pcl is the slow reference")
      ->check(CLI::IsMember({std::string(to_string(Engine::native)), std::string(to_string(Engine::pcl))}))
      ->default_str(std::string(to_string(Engine::native)));
  command.add_option("--stride", segmentation.stride, "Normals of every n-th column alone: faster, less exact")
      ->check(CLI::Range(1, kMostStride))
      ->capture_default_str();
  command.add_flag_callback(
      "--centred", [&options] { options.moment = Moment::about_mean; }, "Subtract the normals' mean (the textbook PCA)");
  std::vector<std::string> names;
  for (const Reading reading : kReadings) names.emplace_back(to_string(reading));
  const auto set_readings = [&options](const std::vector<std::string>& wanted) {
    options.readings.clear();
    for (const Reading reading : kReadings) {
      if (std::ranges::find(wanted, to_string(reading)) != wanted.end()) options.readings.push_back(reading);
    }
  };
  command.add_option_function<std::vector<std::string>>("--readings", set_readings, "What to tell beside alpha, apart by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
}

}  // namespace alignability::cli
