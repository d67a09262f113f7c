// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignability/alignability.hpp"
#include "python/keywords.hpp"

namespace alignability::python {

/// How scans are scored, whatever their sensor.
template <typename Options, typename Place>
void add_scoring(Keywords<Options>& keywords, Place scoring) {
  const auto in = [&](auto place) {
    return [=](Options & options) -> auto& { return place(scoring(options)); };
  };
  keywords.add("normal_neighbours", in([](auto& o) -> auto& { return o.segmentation.normal_neighbours; }));
  keywords.add("growing_neighbours", in([](auto& o) -> auto& { return o.segmentation.growing_neighbours; }));
  keywords.add("smoothness", kNotNegative, in([](auto& o) -> auto& { return o.segmentation.smoothness; }));
  keywords.add("curvature", kNotNegative, in([](auto& o) -> auto& { return o.segmentation.curvature; }));
  keywords.add("min_points", in([](auto& o) -> auto& { return o.segmentation.min_points; }));
  keywords.add("min_line_points", in([](auto& o) -> auto& { return o.segmentation.min_line_points; }));
  keywords.add("stride", in([](auto& o) -> auto& { return o.segmentation.stride; }));
  keywords.add("engine", in([](auto& o) -> auto& { return o.segmentation.engine; }));
  keywords.add("plane_threshold", kShare, in([](auto& o) -> auto& { return o.plane_threshold; }));
  keywords.add("min_area", kNotNegative, in([](auto& o) -> auto& { return o.min_area; }));
  keywords.add("min_length", kNotNegative, in([](auto& o) -> auto& { return o.min_length; }));
  keywords.add("moment", in([](auto& o) -> auto& { return o.moment; }));
  keywords.add("readings", in([](auto& o) -> auto& { return o.readings; }));
  keywords.add("voxel", kPositive, in([](auto& o) -> auto& { return o.voxel; }));
}

}  // namespace alignability::python
