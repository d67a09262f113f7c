// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scoring_options.hpp"

namespace alignability::cli {

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
}

}  // namespace alignability::cli
