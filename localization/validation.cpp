// SPDX-License-Identifier: BSD-3-Clause
#include "localization/validation.hpp"

namespace alignability {
namespace {

std::vector<std::vector<Drive>> runs_of(std::span<const DrivenPath> paths) {
  std::vector<std::vector<Drive>> runs;
  for (const DrivenPath& path : paths) runs.push_back(path.runs);
  return runs;
}

}  // namespace

std::vector<Validation> validate(std::span<const DrivenPath> paths, std::span<const Localizer> localizers,
                                 const ErrorReference& reference) {
  const std::vector<std::vector<Drive>> runs = runs_of(paths);
  std::vector<Validation> validations;
  for (std::size_t i = 0; i < localizers.size(); ++i) {
    const auto errors_of = [&](std::span<const std::vector<Drive>> drives) {
      return path_errors(drives, i, reference.clearance, reference.radius, {});
    };
    Validation validation{.localizer = localizers[i],
                          .errors = errors_of(runs),
                          .by_path = {},
                          .layers = {},
                          .cells = cell_errors(runs, i, reference.map.geometry, reference.settling)};
    for (const DrivenPath& path : paths) validation.by_path.push_back(paths.size() == 1 ? validation.errors : errors_of({&path.runs, 1}));
    for (const char* name : kReadingLayers) {
      const Grid<float>* const layer = reference.map.find_layer(name);
      if (layer != nullptr) validation.layers.push_back({name, prediction(runs, i, *layer, reference.settling, {})});
    }
    validations.push_back(std::move(validation));
  }
  return validations;
}

}  // namespace alignability
