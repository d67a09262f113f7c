// SPDX-License-Identifier: BSD-3-Clause
#include "localization/localizer.hpp"

#include <limits>
#include <vector>

#include "core/input_error.hpp"

namespace alignability {
namespace {

std::variant<NdtMcl, ScanMatcher> started(Localizer localizer, const LocalizationMap& map, const Pose2& start,
                                          const LocalizerOptions& options, std::uint64_t seed) {
  if (localizer == Localizer::scan_matching) return ScanMatcher(map.planes, start, options.start_deviations, options.scan_matcher);
  NdtMclOptions ndt_mcl = options.ndt_mcl;
  ndt_mcl.combination = localizer == Localizer::ndt_mcl_sum ? CellCombination::sum : CellCombination::product;
  return NdtMcl(map.ndt, start, options.start_deviations, ndt_mcl, seed);
}

// A line's points as an upright plane's: thrice, one above the other, so that their neighbours span it.
std::vector<Eigen::Vector3f> upright(std::span<const Eigen::Vector3f> lines, const PlaneMapOptions& options) {
  const auto step = static_cast<float>(0.5 * options.neighbourhood);
  std::vector<Eigen::Vector3f> points;
  points.reserve(3 * lines.size());
  for (const Eigen::Vector3f& point : lines) {
    for (const float height : {-step, 0.0f, step}) points.emplace_back(point.x(), point.y(), point.z() + height);
  }
  return points;
}

std::shared_ptr<const PlaneMap> planes_of(std::span<const Eigen::Vector3f> cloud, const LocalizerOptions& options) {
  const PlaneMapOptions planes;
  if (options.ndt.shape == NdtCells::cubes) return std::make_shared<const PlaneMap>(cloud, planes);
  return std::make_shared<const PlaneMap>(upright(cloud, planes), planes);
}

}  // namespace

LocalizerOptions for_sensor(LocalizerOptions options, const SensorRig& sensor) {
  if (!sensor.is_planar()) return options;
  options.ndt.shape = NdtCells::squares;
  options.ndt_mcl.least_height = options.scan_matcher.least_height = std::numeric_limits<double>::lowest();
  return options;
}

const char* to_string(Localizer localizer) {
  for (const auto& [name, named] : kLocalizers) {
    if (named == localizer) return name;
  }
  return "";
}

std::optional<Localizer> localizer_named(std::string_view name) {
  for (const auto& [known, localizer] : kLocalizers) {
    if (known == name) return localizer;
  }
  return std::nullopt;
}

std::string refusal_of_localizer(const std::string& name) {
  std::vector<std::string> names;
  std::string refusal = "there is no localizer '" + name + '\'';
  for (const auto& known : kLocalizers) names.emplace_back(known.first);
  refusal += did_you_mean(name, names);
  refusal += ": take ";
  for (std::size_t i = 0; i < names.size(); ++i) refusal += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return refusal;
}

LocalizationMap::LocalizationMap(std::span<const Eigen::Vector3f> cloud, const LocalizerOptions& options,
                                 std::span<const Localizer> localizers) {
  for (const Localizer localizer : localizers) {
    if (localizer == Localizer::scan_matching) {
      if (!planes) planes = planes_of(cloud, options);
    } else if (!ndt) {
      ndt = std::make_shared<const Ndt>(cloud, options.ndt);
    }
  }
}

RunningLocalizer::RunningLocalizer(Localizer localizer, const LocalizationMap& map, const Pose2& start, const LocalizerOptions& options,
                                   std::uint64_t seed)
    : localizer_(started(localizer, map, start, options, seed)) {}

void RunningLocalizer::move(const Pose2& motion) {
  std::visit([&](auto& localizer) { localizer.move(motion); }, localizer_);
}

void RunningLocalizer::see(std::span<const Eigen::Vector3f> points, const Ndt& ndt) {
  if (auto* const mcl = std::get_if<NdtMcl>(&localizer_)) {
    mcl->see(ndt);
  } else {
    std::get<ScanMatcher>(localizer_).see(points);
  }
}

Pose2 RunningLocalizer::estimate() const {
  return std::visit([](const auto& localizer) { return localizer.estimate(); }, localizer_);
}

}  // namespace alignability
