// SPDX-License-Identifier: BSD-3-Clause
#include "cli/validate_pictures.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "cli/drive_paths.hpp"
#include "cli/output_name.hpp"
#include "cli/path_output.hpp"
#include "pictures/error_map_picture.hpp"
#include "pictures/error_profile_picture.hpp"
#include "pictures/scatter_picture.hpp"
#include "planner/path_figures.hpp"

namespace alignability::cli {
namespace {

std::string title_of(const Validation& validation, const std::filesystem::path& name) {
  return name.filename().string() + ", " + to_string(validation.localizer);
}

std::filesystem::path name_of(const Validation& validation, const std::filesystem::path& name) {
  return with_ending(name, std::string("_") + to_string(validation.localizer));
}

Grid<float> error_grid(const Validation& validation, const GridGeometry& cells) {
  Grid<float> errors(cells, std::numeric_limits<float>::quiet_NaN());
  for (const CellErrors& at : validation.cells) errors[at.cell] = static_cast<float>(at.error);
  return errors;
}

std::vector<Eigen::Vector2d> points_of(const Validation& validation, const Grid<float>& alpha, double CellErrors::*figure) {
  std::vector<Eigen::Vector2d> points;
  for (const CellErrors& at : validation.cells) points.emplace_back(alpha[at.cell], at.*figure);
  return points;
}

// After the paper's Fig. 4.
void draw_scatter_of(const Validation& validation, const PlanProblem& problem, const std::filesystem::path& name,
                     const PictureKinds& kinds) {
  const Grid<float>& alpha = problem.alignability.alpha();
  const ChartAxis alpha_axis{.name = "alignability",
                             .thresholds = {{problem.query.risk.alpha_critical, "blind"}, {problem.query.risk.alpha_safe, "safe"}}};
  const ChartAxis error_axis{.name = "mean error of the cell [m]", .scale = AxisScale::logarithmic, .thresholds = {{0.1, ""}, {0.3, ""}}};
  const ChartAxis growth_axis{.name = "growth of the error [m/m]", .thresholds = {{0.0, ""}}};
  const std::array panels{ScatterPanel{alpha_axis, error_axis, {{"", points_of(validation, alpha, &CellErrors::error)}}},
                          ScatterPanel{alpha_axis, growth_axis, {{"", points_of(validation, alpha, &CellErrors::growth)}}}};
  for (const auto& file : picture_files(with_ending(name_of(validation, name), "_scatter"), kinds)) {
    draw_scatter(panels, title_of(validation, name), file);
  }
}

ErrorProfile profile_of(const DrivenPath& path, std::size_t localizer, const PathErrors& errors, const RiskField& risk) {
  char figures[96];
  std::snprintf(figures, sizeof figures, ": mean %.2f m, 95 %% %.2f m, lost %.0f %%", errors.mean.value, errors.p95.value,
                100.0 * errors.lost.value);
  ErrorProfile profile{.label = path.name + figures, .errors = {}, .alpha = {}};
  for (const ErrorAlong& at : errors_along(path.runs, localizer, kErrorStep)) profile.errors.push_back({at.s, at.mean, at.p95});
  for (const PathSample& at : sample(path.path, risk, kPathStep)) profile.alpha.push_back({at.s, at.alpha});
  return profile;
}

}  // namespace

void draw_error_maps(std::span<const Validation> validations, const PlanProblem& problem, const DrivenPath& path,
                     const std::filesystem::path& name, const PictureKinds& kinds) {
  for (const Validation& validation : validations) {
    const Grid<float> errors = error_grid(validation, problem.alignability.geometry);
    for (const auto& file : picture_files(with_ending(name_of(validation, name), "_error"), kinds)) {
      draw_error_map(errors, problem.occupancy, path.path, {.title = title_of(validation, name)}, file);
    }
    draw_scatter_of(validation, problem, name, kinds);
  }
}

void draw_profiles(std::span<const Validation> validations, std::span<const DrivenPath> paths, const RiskField& risk,
                   const std::filesystem::path& name, const PictureKinds& kinds) {
  for (std::size_t i = 0; i < validations.size(); ++i) {
    std::vector<ErrorProfile> profiles;
    for (std::size_t k = 0; k < paths.size(); ++k) {
      ErrorProfile profile = profile_of(paths[k], i, validations[i].by_path[k], risk);
      profile.colour = route_colour(k);
      profile.style = k % 2 == 0 ? LineStyle::dashed : LineStyle::solid;
      profiles.push_back(std::move(profile));
    }
    ErrorProfileOptions options{.title = title_of(validations[i], name), .risk = risk.options()};
    options.axis.thresholds = {{kLostError, "lost"}};
    for (const auto& file : picture_files(name_of(validations[i], name), kinds)) draw_error_profiles(profiles, options, file);
  }
}

}  // namespace alignability::cli
