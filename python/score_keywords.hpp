// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignability/alignability.hpp"
#include "python/keywords.hpp"

namespace alignability::python {

/// How scans are scored, whatever their sensor.
template <typename Options, typename Place>
void add_scoring(Keywords<Options>& keywords, Place scoring) {
  const auto add = [&](const char* name, auto place) {
    keywords.add(
        name, [=](Options & options) -> auto& { return place(scoring(options)); });
  };
  add(
      "normal_neighbours", [](AlignabilityOptions & o) -> auto& { return o.segmentation.normal_neighbours; });
  add(
      "growing_neighbours", [](AlignabilityOptions & o) -> auto& { return o.segmentation.growing_neighbours; });
  add(
      "smoothness", [](AlignabilityOptions & o) -> auto& { return o.segmentation.smoothness; });
  add(
      "curvature", [](AlignabilityOptions & o) -> auto& { return o.segmentation.curvature; });
  add(
      "min_points", [](AlignabilityOptions & o) -> auto& { return o.segmentation.min_points; });
  add(
      "min_line_points", [](AlignabilityOptions & o) -> auto& { return o.segmentation.min_line_points; });
  add(
      "stride", [](AlignabilityOptions & o) -> auto& { return o.segmentation.stride; });
  add(
      "engine", [](AlignabilityOptions & o) -> auto& { return o.segmentation.engine; });
  add(
      "plane_threshold", [](AlignabilityOptions & o) -> auto& { return o.plane_threshold; });
  add(
      "min_area", [](AlignabilityOptions & o) -> auto& { return o.min_area; });
  add(
      "min_length", [](AlignabilityOptions & o) -> auto& { return o.min_length; });
  add(
      "moment", [](AlignabilityOptions & o) -> auto& { return o.moment; });
  add(
      "readings", [](AlignabilityOptions & o) -> auto& { return o.readings; });
  add(
      "voxel", [](AlignabilityOptions & o) -> auto& { return o.voxel; });
}

}  // namespace alignability::python
