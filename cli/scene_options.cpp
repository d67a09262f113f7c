// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scene_options.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "core/input_error.hpp"
#include "core/range.hpp"

namespace alignability::cli {
namespace {

SdfGeometry geometry_named(const std::string& name) {
  if (name == "visual") return SdfGeometry::visual;
  if (name == "collision") return SdfGeometry::collision;
  const std::vector<std::string> names{"visual", "collision"};
  throw CLI::ValidationError("--geometry", "must be visual or collision, not " + name + did_you_mean(name, names));
}

UpAxis up_axis_named(const std::string& name) {
  if (name == "x") return UpAxis::x;
  if (name == "y") return UpAxis::y;
  if (name == "z") return UpAxis::z;
  throw CLI::ValidationError("--up", "must be x, y or z, not " + name);
}

void tell_of_leveling(const std::filesystem::path& file, const Eigen::Isometry3d& T_map_file) {
  if (T_map_file.isApprox(Eigen::Isometry3d::Identity())) return;
  const double tilt = std::acos(std::min(1.0, T_map_file.linear()(2, 2))) * 180.0 / std::numbers::pi;
  std::cerr << file.string() << ": leveled by " << fixed_text(tilt, 2) << " degrees; its origin is "
            << fixed_text(T_map_file.translation().z(), 2) << " m above the floor\n";
}

Scene scene_of(Site site) { return Scene(std::move(site.meshes), std::move(site.discs)); }

}  // namespace

void add_site_options(CLI::App& command, SiteOptions& options) {
  command.add_option("--model-path", options.world.model_paths, "Folder to look for models in; may be given more than once")
      ->check(CLI::ExistingDirectory)
      ->option_text("FOLDER");
  command
      .add_option_function<std::string>(
          "--geometry", [&options](const std::string& name) { options.world.geometry = geometry_named(name); },
          "Which geometry of a world: collision (default) or visual")
      ->option_text("visual|collision");
  command.add_option("--unit", options.unit, "Metres a unit of a mesh or cloud, in place of what its file says (1 where it says nothing)")
      ->check(CLI::PositiveNumber);
  command
      .add_option_function<std::string>(
          "--up", [&options](const std::string& name) { options.up_axis = up_axis_named(name); },
          "Axis of a mesh or cloud that points up, in place of what its file says (z where it says nothing)")
      ->option_text("x|y|z");
  command.add_option("--thin", options.discs.thinning, "Side of the cubes [m] of which each keeps one point of a cloud")
      ->check(CLI::PositiveNumber);
  command.add_flag("--level", options.level, "Turn and lift a cloud so that its floor is z = 0");
}

Site read_site_telling(const std::filesystem::path& file, const SiteOptions& options) {
  Site site = read_site(file, options);
  for (const std::string& warning : site.warnings) std::cerr << "warning: " << warning << '\n';
  if (!site.discs.empty()) {
    std::cerr << file.string() << ": " << site.discs.size() << " points, on each a disc, of " << median_radius(site.discs)
              << " m radius in the median\n";
    tell_of_leveling(file, site.T_map_file);
  }
  return site;
}

Scene read_scene(const std::filesystem::path& file, const SiteOptions& options) { return scene_of(read_site_telling(file, options)); }

Scene read_scene_quietly(const std::filesystem::path& file, const SiteOptions& options) { return scene_of(read_site(file, options)); }

}  // namespace alignability::cli
