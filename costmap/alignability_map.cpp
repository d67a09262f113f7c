// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/alignability_map.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/file.hpp"
#include "core/yaml_map.hpp"
#include "costmap/float_tiff.hpp"
#include "costmap/heading_layers.hpp"

namespace alignability {
namespace {

constexpr int kLargestSide = 1 << 20;

// Whether a literal block of YAML, which people can read, reads back as the text: such a block ends with one line break, does not begin
// with a space, and has no other control characters.
bool reads_back_as_block(std::string_view text) {
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < ' ' && letter != '\n'; };
  return text.ends_with('\n') && !text.ends_with("\n\n") && !text.starts_with(' ') && !text.starts_with('\n') &&
         std::ranges::none_of(text, is_control);
}

std::filesystem::path with_suffix(const std::filesystem::path& name, const char* suffix) {
  return std::filesystem::path(name.string() + suffix);
}

ErrorModel read_error_model(YamlMap yaml) {
  ErrorModel model;
  model.growth = yaml.number("growth", kNotNegative);
  model.recovery = yaml.number("recovery", kPositive);
  model.least = yaml.number("least", kNotNegative);
  model.alpha_poor = yaml.number("alpha_poor", kShare);
  model.alpha_rich = yaml.number("alpha_rich", kShare);
  if (model.alpha_poor >= model.alpha_rich) yaml.fail("alpha_poor", "'alpha_poor' must be less than 'alpha_rich'");
  Calibration& calibration = model.calibration;
  calibration.localizer = yaml.text("localizer");
  calibration.sensor = yaml.text("sensor");
  calibration.noise = yaml.number("noise", kNotNegative);
  calibration.range_max = yaml.find_number("range_max", kPositive);
  calibration.scale_bias = yaml.number("odometry_bias", kFinite);
  yaml.finish();
  return model;
}

void emit(YAML::Emitter& out, const ErrorModel& model) {
  const auto number = [&](const char* key, double value) { out << YAML::Key << key << YAML::Value << to_text(value); };
  out << YAML::Key << "error_model" << YAML::Value << YAML::BeginMap;
  number("growth", model.growth);
  number("recovery", model.recovery);
  number("least", model.least);
  number("alpha_poor", model.alpha_poor);
  number("alpha_rich", model.alpha_rich);
  out << YAML::Key << "localizer" << YAML::Value << model.calibration.localizer;
  out << YAML::Key << "sensor" << YAML::Value << model.calibration.sensor;
  number("noise", model.calibration.noise);
  if (model.calibration.range_max) number("range_max", *model.calibration.range_max);
  number("odometry_bias", model.calibration.scale_bias);
  out << YAML::EndMap;
}

std::string yaml_text(const AlignabilityMap& map, const std::filesystem::path& image) {
  YAML::Emitter out;
  const auto block = [&out](const char* key, const std::string& text) {
    if (text.empty()) return;
    out << YAML::Key << key << YAML::Value << (reads_back_as_block(text) ? YAML::Literal : YAML::DoubleQuoted) << text;
  };
  out << YAML::BeginMap << YAML::Key << "image" << YAML::Value << image.filename().string();
  out << YAML::Key << "resolution" << YAML::Value << to_text(map.geometry.resolution);
  out << YAML::Key << "origin" << YAML::Value << YAML::Flow << YAML::BeginSeq << to_text(map.geometry.origin.x())
      << to_text(map.geometry.origin.y()) << YAML::EndSeq;
  out << YAML::Key << "size" << YAML::Value << YAML::Flow << YAML::BeginSeq << map.geometry.width << map.geometry.height << YAML::EndSeq;
  out << YAML::Key << "layers" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const AlignabilityMap::Layer& layer : map.layers) out << layer.name;
  out << YAML::EndSeq << YAML::Key << "seed" << YAML::Value << map.seed;
  if (map.error_model) emit(out, *map.error_model);
  block("options", map.options);
  block("provenance", map.provenance);
  block("sensor", map.sensor);
  out << YAML::EndMap;
  return std::string(out.c_str()) + '\n';
}

GridGeometry read_geometry(YamlMap& yaml) {
  GridGeometry geometry;
  geometry.resolution = yaml.number("resolution", kPositive);
  const auto origin = yaml.numbers("origin", 2, kFinite);
  geometry.origin = {origin[0], origin[1]};
  const auto size = yaml.numbers("size", 2, {.min = 1, .max = kLargestSide});
  geometry.width = static_cast<int>(size[0]);
  geometry.height = static_cast<int>(size[1]);
  if (geometry.width != size[0] || geometry.height != size[1]) yaml.fail("size", "'size' must be whole numbers of cells");
  return geometry;
}

std::vector<std::string> read_layer_names(YamlMap& yaml) {
  std::vector<std::string> names = yaml.texts("layers");
  if (names.empty() || names.front() != "alpha") yaml.fail("layers", "'layers' must be a list whose first name is 'alpha'");
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) != name) yaml.fail("layers", "'layers' names '" + *name + "' twice");
  }
  if (const auto fault = fault_of_heading_layers(names)) yaml.fail("layers", *fault);
  return names;
}

std::uint64_t read_seed(YamlMap& yaml) {
  const std::string text = yaml.find_text("seed").value_or("0");
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) {
    yaml.fail("seed",
              "'seed' must be a whole number from 0 to " + std::to_string(std::numeric_limits<std::uint64_t>::max()) + ", not " + text);
  }
  return seed;
}

}  // namespace

const Grid<float>* AlignabilityMap::find_layer(std::string_view name) const {
  const auto found = std::ranges::find(layers, name, &Layer::name);
  return found == layers.end() ? nullptr : &found->values;
}

AlignabilityMap read_alignability_map(const std::filesystem::path& yaml_file) {
  YamlMap yaml = YamlMap::from_file(yaml_file);
  AlignabilityMap map;
  const auto image = yaml.path("image");
  map.geometry = read_geometry(yaml);
  const auto names = read_layer_names(yaml);
  map.seed = read_seed(yaml);
  if (const auto model = yaml.find_map("error_model")) map.error_model = read_error_model(*model);
  map.options = yaml.find_text("options").value_or("");
  map.provenance = yaml.find_text("provenance").value_or("");
  map.sensor = yaml.find_text("sensor").value_or("");
  yaml.finish();

  std::vector<Grid<float>> pages = detail::read_float_tiff(image, map.geometry, names.size());
  if (pages.size() != names.size()) {
    throw InputError(image, "has " + std::to_string(pages.size()) + " pages where " + yaml_file.filename().string() + " names " +
                                std::to_string(names.size()) + " layers");
  }
  for (std::size_t i = 0; i < names.size(); ++i) map.layers.push_back({names[i], std::move(pages[i])});
  std::vector<const Grid<float>*> alphas = heading_layers(map);
  alphas.push_back(&map.alpha());
  const auto is_valid = [](float alpha) { return std::isnan(alpha) || (alpha >= 0.0f && alpha <= 1.0f); };
  for (const Grid<float>* alpha : alphas) {
    if (!std::ranges::all_of(alpha->values(), is_valid))
      throw InputError(image, "holds an alignability that is neither from 0 to 1 nor NaN");
  }
  return map;
}

void write_alignability_map(const AlignabilityMap& map, const std::filesystem::path& name) {
  const auto image = with_suffix(name, ".tiff");
  detail::write_float_tiff(image, map.layers);
  write_file(with_suffix(name, ".yaml"), yaml_text(map, image));
}

}  // namespace alignability
