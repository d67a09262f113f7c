// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/map_layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace alignability::detail {
namespace {

constexpr double kHatchSpacing = 9.0;
constexpr double kHatchWidth = 1.2;

struct CellRange {
  int first = 0;
  int last = 0;  // one past
};

// The cells that a pixel shows, given its edges in cells: the one under its centre, or all whose centre lies in it when there are several.
CellRange cells_under(double edge_a, double edge_b, int count) {
  const auto [low, high] = std::minmax(edge_a, edge_b);
  const bool several = high - low >= 1.0;
  const double first = several ? std::round(low) : std::floor(0.5 * (low + high));
  const double last = several ? std::round(high) : first + 1.0;
  const auto limited = [count](double index) { return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count))); };
  return {limited(first), limited(last)};
}

// By pixel column of the frame from the left, by pixel row from the top.
struct PixelCells {
  std::vector<CellRange> columns;
  std::vector<CellRange> rows;
};

PixelCells cells_by_pixel(const View& view, const GridGeometry& geometry) {
  PixelCells cells;
  const double cells_per_pixel = 1.0 / (view.scale * geometry.resolution);
  const double left = (view.lower.x() - geometry.origin.x()) / geometry.resolution;
  const double bottom = (view.lower.y() - geometry.origin.y()) / geometry.resolution;
  for (double x = 0.0; x < view.frame.width; ++x) {
    cells.columns.push_back(cells_under(left + x * cells_per_pixel, left + (x + 1.0) * cells_per_pixel, geometry.width));
  }
  for (double y = view.frame.height; y > 0.0; --y) {
    cells.rows.push_back(cells_under(bottom + (y - 1.0) * cells_per_pixel, bottom + y * cells_per_pixel, geometry.height));
  }
  return cells;
}

float mean_of_known(const Grid<float>& values, const CellRange& columns, const CellRange& rows) {
  double sum = 0.0;
  int known = 0;
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      const float value = values[Cell{x, y}];
      if (std::isnan(value)) continue;
      sum += value;
      ++known;
    }
  }
  return static_cast<float>(sum / known);
}

enum class Look { plain, wall, unknown };

Look look_of(const OccupancyMap& occupancy, const CellRange& columns, const CellRange& rows) {
  bool any_free = false;
  bool any = false;
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      const Cell cell{x, y};
      const bool free = occupancy.is_free(occupancy.geometry().index(cell));
      if (!free && occupancy.occupancy(cell)) return Look::wall;
      any_free |= free;
      any = true;
    }
  }
  return any && !any_free ? Look::unknown : Look::plain;
}

std::uint32_t opaque_pixel(const Colour& colour) {
  const auto byte = [](double part) { return static_cast<std::uint32_t>(std::lround(255.0 * part)); };
  return 0xff000000u | byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

// An image of the frame's size that drawing goes to pixel by pixel before it is put on the page.
template <typename Pixel>
class Raster {
 public:
  Raster(const View& view, Cairo::Surface::Format format)
      : frame_(view.frame),
        surface_(Cairo::ImageSurface::create(format, static_cast<int>(view.frame.width), static_cast<int>(view.frame.height))) {
    surface_->flush();
  }
  void set(std::size_t column, std::size_t row, Pixel pixel) {
    unsigned char* line = surface_->get_data() + row * static_cast<std::size_t>(surface_->get_stride());
    reinterpret_cast<Pixel*>(line)[column] = pixel;
  }
  // In its place on the page, and with sharp pixels where the page is enlarged.
  Cairo::RefPtr<Cairo::SurfacePattern> finished() {
    surface_->mark_dirty();
    const auto pattern = Cairo::SurfacePattern::create(surface_);
    pattern->set_matrix(Cairo::translation_matrix(-frame_.left, -frame_.top));
    pattern->set_filter(Cairo::SurfacePattern::Filter::NEAREST);
    return pattern;
  }

 private:
  Rectangle frame_;
  Cairo::RefPtr<Cairo::ImageSurface> surface_;
};

void draw_not_evaluated(const Context& context, const View& view, const GridGeometry& geometry) {
  fill_rectangle(context, view.to_pixels({geometry.origin, geometry.upper_corner()}), kNotEvaluated);
}

void draw_values(const Context& context, const View& view, const Grid<float>& values, const ColourScale& colour_of) {
  const PixelCells cells = cells_by_pixel(view, values.geometry());
  Raster<std::uint32_t> raster(view, Cairo::Surface::Format::ARGB32);
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    for (std::size_t column = 0; column < cells.columns.size(); ++column) {
      const float value = mean_of_known(values, cells.columns[column], cells.rows[row]);
      if (!std::isnan(value)) raster.set(column, row, opaque_pixel(colour_of(value)));
    }
  }
  context->set_source(raster.finished());
  context->paint();
}

}  // namespace

void draw_occupancy(const Context& context, const View& view, const OccupancyMap& occupancy, Tone tone) {
  const PixelCells cells = cells_by_pixel(view, occupancy.geometry());
  Raster<std::uint8_t> walls(view, Cairo::Surface::Format::A8);
  Raster<std::uint8_t> unknown(view, Cairo::Surface::Format::A8);
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    for (std::size_t column = 0; column < cells.columns.size(); ++column) {
      const Look look = look_of(occupancy, cells.columns[column], cells.rows[row]);
      if (look == Look::wall) walls.set(column, row, 0xff);
      if (look == Look::unknown) unknown.set(column, row, 0xff);
    }
  }
  context->push_group();
  paint_hatch(context, view.frame);
  context->pop_group_to_source();
  context->mask(unknown.finished());
  set_colour(context, wall_colour(tone));
  context->mask(walls.finished());
}

void draw_map(const Context& context, const View& view, const Grid<float>& values, const ColourScale& colour_of,
              const OccupancyMap& occupancy, Tone tone) {
  draw_not_evaluated(context, view, occupancy.geometry());
  draw_not_evaluated(context, view, values.geometry());
  draw_values(context, view, values, colour_of);
  draw_occupancy(context, view, occupancy, tone);
}

void paint_hatch(const Context& context, const Rectangle& area) {
  fill_rectangle(context, area, kUnknown);
  context->save();
  add_rectangle(context, area);
  context->clip();
  set_colour(context, kHatch);
  context->set_line_width(kHatchWidth);
  for (double x = area.left - area.height; x < area.right(); x += kHatchSpacing) {
    context->move_to(x, area.bottom());
    context->line_to(x + area.height, area.top);
  }
  context->stroke();
  context->restore();
}

}  // namespace alignability::detail
