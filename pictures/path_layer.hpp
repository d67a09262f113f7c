// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "pictures/path_picture.hpp"
#include "pictures/view.hpp"

namespace alignability::detail {

/// The paths, their blind stretches, start and goal; cut off at the view's frame.
void draw_path_layer(const Context& context, const View& view, std::span<const DrawnPath> paths, const PathPictureOptions& options);

/// What the line of a path, and a blind stretch, look like in a key: from `left_middle` to the right.
void draw_path_sample(const Context& context, const Eigen::Vector2d& left_middle, const DrawnPath& path);
void draw_blind_sample(const Context& context, const Eigen::Vector2d& left_middle);
inline constexpr double kSampleLength = 62.0;

}  // namespace alignability::detail
