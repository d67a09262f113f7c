// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace alignability {

/// What a path planned with a weight of the risk comes to.
struct TradeOffPoint {
  double weight = 0.0;
  double length = 0.0;        ///< [m]
  double blind_length = 0.0;  ///< [m]
};

/// Draws blind metres against length, a point a weight, joined in the order given. Weights that share a point share a label.
/// Throws InputError when the file is not named .png, .svg or .pdf, or cannot be written.
void draw_trade_off(std::span<const TradeOffPoint> points, const std::string& title, const std::filesystem::path& file);

}  // namespace alignability
