// SPDX-License-Identifier: BSD-3-Clause
#include "cli/validate_output.hpp"

#include <cmath>
#include <cstdio>

#include "core/file.hpp"
#include "core/range.hpp"

namespace alignability::cli {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json interval_json(const Interval& interval) {
  return {{"value", number(interval.value)}, {"low", number(interval.low)}, {"high", number(interval.high)}};
}

Json bounds_json(const Interval& interval) { return {number(interval.low), number(interval.high)}; }

const char* to_string(Statement::Verdict verdict) {
  switch (verdict) {
    case Statement::Verdict::holds:
      return "holds";
    case Statement::Verdict::fails:
      return "fails";
    case Statement::Verdict::untested:
      return "untested";
  }
  return "";
}

Json statement_json(const Statement& statement) {
  return {{"verdict", to_string(statement.verdict())},
          {"cells", statement.cells},
          {"exceptions", statement.exceptions},
          {"cells_on_the_other_side", statement.others}};
}

Json prediction_json(const Prediction& prediction) {
  return {{"error", interval_json(prediction.error)}, {"growth", interval_json(prediction.growth)}};
}

double length_of(const DrivenPath& path) { return path.runs.front().empty() ? 0.0 : path.runs.front().back().truth.s; }

void print_row(const std::string& name, const PathErrors& errors) {
  std::printf("%-22s %7.3f %7.3f %7.3f %7.3f   %5.1f %%  %5.1f %%\n", name.c_str(), errors.mean.value, errors.p95.value, errors.max.value,
              errors.goal.value, 100.0 * errors.lost.value, 100.0 * errors.unsafe.value);
}

void print_statement(const char* text, const Statement& statement) {
  std::printf("%s: %s (%zu of %zu cells are otherwise; %zu on the other side)\n", text, to_string(statement.verdict()),
              statement.exceptions, statement.cells, statement.others);
}

}  // namespace

Json errors_json(const PathErrors& errors) {
  return {{"error", {{"mean", number(errors.mean.value)}, {"p95", number(errors.p95.value)}, {"max", number(errors.max.value)}}},
          {"goal_error", number(errors.goal.value)},
          {"lost_share", number(errors.lost.value)},
          {"unsafe_share", number(errors.unsafe.value)},
          {"intervals",
           {{"mean", bounds_json(errors.mean)},
            {"p95", bounds_json(errors.p95)},
            {"max", bounds_json(errors.max)},
            {"goal_error", bounds_json(errors.goal)},
            {"lost_share", bounds_json(errors.lost)},
            {"unsafe_share", bounds_json(errors.unsafe)}}}};
}

Json validation_json(const Validation& validation, std::span<const DrivenPath> paths, const TrialOptions& options,
                     const GridGeometry& cells) {
  Json json{{"localizer", to_string(validation.localizer)}, {"runs", options.runs}, {"seeds", Json::array()}};
  for (int run = 0; run < options.runs; ++run) json["seeds"].push_back(options.seed + static_cast<std::uint64_t>(run));
  json.update(errors_json(validation.errors));
  const Prediction& alpha = validation.layers.front().prediction;
  json["spearman"] = interval_json(alpha.error);
  json["spearman_growth"] = interval_json(alpha.growth);
  json["readings"] = Json::object();
  for (const auto& [layer, predicted] : validation.layers) json["readings"][layer] = prediction_json(predicted);
  json["above_0.3_m_only_where_alpha_below_0.1"] = statement_json(alpha.large_only_where_poor);
  json["below_0.1_m_where_alpha_above_0.4"] = statement_json(alpha.small_where_rich);
  json["paths"] = Json::array();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Json path{{"name", paths[i].name}, {"length", length_of(paths[i])}};
    path.update(errors_json(validation.by_path[i]));
    json["paths"].push_back(std::move(path));
  }
  json["cells"] = Json::array();
  for (const CellErrors& at : validation.cells) {
    const Eigen::Vector2d center = cells.center(at.cell);
    json["cells"].push_back({{"x", center.x()}, {"y", center.y()}, {"error", number(at.error)}, {"growth", number(at.growth)}});
  }
  return json;
}

void print_errors(const Validation& validation, std::span<const DrivenPath> paths) {
  std::printf("%-22s %7s %7s %7s %7s   %7s  %7s\n", to_string(validation.localizer), "mean", "95 %", "max", "goal", "lost", "unsafe");
  for (std::size_t i = 0; i < paths.size(); ++i) print_row(paths[i].name, validation.by_path[i]);
  if (paths.size() > 1) print_row("all", validation.errors);
}

void print_predictions(const Validation& validation) {
  std::printf("rank correlation over %zu cells, with its 95 %% interval over the runs\n", validation.cells.size());
  for (const auto& [layer, predicted] : validation.layers) {
    std::printf("  %-12s with the error %6.2f (%5.2f to %5.2f), with its growth %6.2f (%5.2f to %5.2f)\n", layer.c_str(),
                predicted.error.value, predicted.error.low, predicted.error.high, predicted.growth.value, predicted.growth.low,
                predicted.growth.high);
  }
  const Prediction& alpha = validation.layers.front().prediction;
  print_statement("errors above 0.3 m only where alpha < 0.1", alpha.large_only_where_poor);
  print_statement("errors below 0.1 m where alpha > 0.4", alpha.small_where_rich);
}

void write_cells_csv(std::span<const Validation> validations, const AlignabilityMap& map, const std::filesystem::path& csv) {
  std::string text = "x,y";
  std::vector<const Grid<float>*> layers;
  for (const char* name : kReadingLayers) {
    if (const Grid<float>* const layer = map.find_layer(name)) {
      layers.push_back(layer);
      text += std::string(",") + name;
    }
  }
  for (const Validation& validation : validations) {
    const std::string localizer = to_string(validation.localizer);
    text += ',' + localizer + "_error," + localizer + "_growth";
  }
  text += '\n';
  const auto field = [](double value) { return ',' + (std::isfinite(value) ? to_text(value) : std::string()); };
  for (std::size_t i = 0; i < validations.front().cells.size(); ++i) {  // every localizer saw the same cells
    const Cell cell = validations.front().cells[i].cell;
    const Eigen::Vector2d center = map.geometry.center(cell);
    text += to_text(center.x()) + ',' + to_text(center.y());
    for (const Grid<float>* const layer : layers) text += field((*layer)[cell]);
    for (const Validation& validation : validations) text += field(validation.cells[i].error) + field(validation.cells[i].growth);
    text += '\n';
  }
  write_file(csv, text);
}

}  // namespace alignability::cli
