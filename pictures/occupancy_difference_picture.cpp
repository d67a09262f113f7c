// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/occupancy_difference_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pictures/axes.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kSwatchWidth = 24.0;
constexpr double kSwatchHeight = 20.0;
constexpr Colour kWithinACell = colour_from_hex(0xb5dcae);
constexpr Colour kInFirst = colour_from_hex(0xe2001a);
constexpr Colour kInSecond = colour_from_hex(0x1f4fd8);

Colour colour_of(CellAgreement agreement) {
  switch (agreement) {
    case CellAgreement::not_compared:
      return kNotEvaluated;
    case CellAgreement::both_free:
      return kWhite;
    case CellAgreement::both_occupied:
      return wall_colour(Tone::full);
    case CellAgreement::within_a_cell:
      return kWithinACell;
    case CellAgreement::occupied_in_first:
      return kInFirst;
    case CellAgreement::occupied_in_second:
      return kInSecond;
  }
  return kWhite;
}

// A cell on whole pixels, where it has any.
View view_of(const GridGeometry& geometry) {
  const double pixels = kLongSide / std::max({geometry.width, geometry.height, 1});
  const double scale = (pixels < 1.0 ? pixels : std::floor(pixels)) / geometry.resolution;
  return detail::view_of({geometry.origin, geometry.upper_corner()}, scale);
}

std::vector<std::pair<CellAgreement, std::string>> key_of(const DifferencePictureOptions& options) {
  return {{CellAgreement::both_occupied, "occupied in both"},
          {CellAgreement::within_a_cell, "occupied in one, and within a cell in the other"},
          {CellAgreement::occupied_in_first, "occupied in " + options.first + " alone"},
          {CellAgreement::occupied_in_second, "occupied in " + options.second + " alone"},
          {CellAgreement::not_compared, "unknown in one of them"}};
}

void draw_key_line(const Context& context, const MapLayout& layout, const Eigen::Vector2d& at, const Colour& colour,
                   const std::string& label) {
  const Rectangle swatch{at.x(), std::floor(at.y() - 0.5 * kSwatchHeight), kSwatchWidth, kSwatchHeight};
  fill_rectangle(context, swatch, colour);
  outline_rectangle(context, swatch, kInk);
  const Eigen::Vector2d beside(swatch.right() + 11.0, at.y());
  draw_text(context, label, beside, {.anchor = {0.0, 0.5}, .widest = layout.width - kMargin - beside.x()});
}

}  // namespace

void draw_occupancy_difference(const OccupancyDifference& difference, const DifferencePictureOptions& options,
                               const std::filesystem::path& file) {
  const GridGeometry& geometry = difference.cells.geometry();
  const auto key = key_of(options);
  const MapLayout layout = lay_out(view_of(geometry), options.title, key.size(), 0.0);
  const Page page(layout.width, layout.bottom + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  for (std::size_t i = 0; i < key.size(); ++i) {
    draw_key_line(context, layout, key_line(layout, options.title, i), colour_of(key[i].first), key[i].second);
  }
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const Eigen::Vector2d corner = geometry.corner(geometry.cell_of(i));
    const WorldBox box{corner, corner + Eigen::Vector2d::Constant(geometry.resolution)};
    fill_rectangle(context, layout.view.to_pixels(box), colour_of(difference.cells[i]));
  }
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  page.save(file);
}

}  // namespace alignability
