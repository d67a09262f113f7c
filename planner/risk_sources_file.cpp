// SPDX-License-Identifier: BSD-3-Clause
#include "planner/risk_sources_file.hpp"

#include <array>

namespace alignability::detail {
namespace {

constexpr std::pair<const char*, UnknownPolicy> kPolicies[] = {{"risky", UnknownPolicy::risky}, {"neutral", UnknownPolicy::neutral}};

bool is_tiff(const std::filesystem::path& file) { return file.extension() == ".tiff" || file.extension() == ".tif"; }

RasterFile read_raster_file(YamlMap& yaml) {
  RasterFile raster{.file = yaml.path("raster")};
  if (is_tiff(raster.file)) {
    const double resolution = yaml.number("resolution", kPositive);
    const auto origin = yaml.numbers("origin", 2, kFinite);
    raster.place = RasterPlace{resolution, {origin[0], origin[1]}};
    return raster;
  }
  for (const char* key : {"resolution", "origin"}) {
    if (yaml.has(key)) yaml.fail(key, std::string("'").append(key).append("' belongs to a .tiff: other rasters say where they lie"));
  }
  raster.layer = yaml.find_text("layer").value_or("");
  return raster;
}

RiskSource read_source(const std::string& name, YamlMap yaml) {
  const bool is_clearance = name == kClearance;
  RiskSource source;
  source.name = name;
  source.weight = yaml.number("weight", kCostWeights);
  if (!is_clearance) source.file = read_raster_file(yaml);
  const Range& values = is_clearance ? kNotNegative : kFinite;
  source.risky = yaml.number("risky", values);
  source.safe = yaml.number("safe", values);
  if (!is_clearance) source.unknown = yaml.find_choice("unknown", kPolicies).value_or(source.unknown);
  yaml.finish();
  if (source.risky == source.safe) yaml.fail("safe", "'risky' and 'safe' must differ");
  return source;
}

// A name that is misspelt is taken for that of a raster otherwise.
void check_name(const YamlMap& sources, const std::string& name, const YamlMap& source) {
  if (!is_source_name(name)) sources.fail(name, "the name of a source must be made of letters, digits, '_' and '-'");
  if (name == kClearance || source.has("raster")) return;
  const std::array<std::string, 2> own{kAlignability, kClearance};
  const std::string hint = did_you_mean(name, own);
  if (!hint.empty()) sources.fail(name, "'" + name + "' has no 'raster', and is no source of our own" + hint);
}

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

std::string source_text(const RiskSource& source) {
  std::string text = source.name + ": {weight: " + to_text(source.weight);
  const auto add = [&](const char* key, const std::string& value) { text.append(", ").append(key).append(": ").append(value); };
  if (source.file) {
    add("raster", quoted(source.file->file.string()));
    if (!source.file->layer.empty()) add("layer", quoted(source.file->layer));
  }
  if (source.file && source.file->place) {
    const RasterPlace& place = *source.file->place;
    add("resolution", to_text(place.resolution));
    add("origin", '[' + to_text(place.origin.x()) + ", " + to_text(place.origin.y()) + ']');
  }
  add("risky", to_text(source.risky));
  add("safe", to_text(source.safe));
  if (source.file) add("unknown", source.unknown == UnknownPolicy::neutral ? "neutral" : "risky");
  return text + '}';
}

}  // namespace

RiskSources read_risk_sources(YamlMap yaml) {
  RiskSources read;
  for (const std::string& name : yaml.keys()) {
    YamlMap source = yaml.map(name);
    if (name == kAlignability) {
      read.alpha_weight = source.number("weight", kCostWeights);
      source.finish();
      continue;
    }
    check_name(yaml, name, source);
    read.sources.push_back(read_source(name, source));
    read.raster_places.push_back(source.position("raster"));
  }
  return read;
}

std::vector<RiskSource> with_values(const ProblemFile& file, const OccupancyMap& occupancy) {
  std::vector<RiskSource> sources = file.query.risk.sources;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    RiskSource& source = sources[i];
    source.values = std::make_shared<const Grid<float>>(source.file ? read_raster(*source.file) : clearance_values(occupancy));
    if (const auto fault = fault_of_source(source, occupancy.geometry())) throw InputError(file.file, file.raster_places[i], *fault);
  }
  return sources;
}

std::string sources_text(const RiskOptions& risk) {
  if (risk.sources.empty() && risk.alpha_weight == 1.0) return "";
  std::string text = ", sources: {" + std::string(kAlignability) + ": {weight: " + to_text(risk.alpha_weight) + '}';
  for (const RiskSource& source : risk.sources) text += ", " + source_text(source);
  return text + '}';
}

}  // namespace alignability::detail
