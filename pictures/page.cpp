// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/page.hpp"

#include <cmath>
#include <string>

#include "core/file.hpp"
#include "pictures/colour_map.hpp"

namespace alignability::detail {

Page::Page(double width, double height)
    : surface_(Cairo::ImageSurface::create(Cairo::Surface::Format::RGB24, static_cast<int>(std::ceil(width)),
                                           static_cast<int>(std::ceil(height)))),
      context_(Cairo::Context::create(surface_)) {
  set_colour(context_, kWhite);
  context_->paint();
  // Outlines as the font has them: hinted to whole pixels, spacing turns uneven.
  Cairo::FontOptions font;
  font.set_hint_style(Cairo::FontOptions::HintStyle::NONE);
  font.set_hint_metrics(Cairo::FontOptions::HintMetrics::OFF);
  font.set_antialias(Cairo::ANTIALIAS_GRAY);
  context_->set_font_options(font);
}

void Page::save(const std::filesystem::path& png) const {
  std::string bytes;
  surface_->write_to_png_stream([&bytes](const unsigned char* data, unsigned int length) {
    bytes.append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  });
  write_file(png, bytes);
}

void set_colour(const Context& context, const Colour& colour) { context->set_source_rgb(colour.red, colour.green, colour.blue); }

void set_colour(const Context& context, const Colour& colour, double opacity) {
  context->set_source_rgba(colour.red, colour.green, colour.blue, opacity);
}

void add_rectangle(const Context& context, const Rectangle& rectangle) {
  context->rectangle(rectangle.left, rectangle.top, rectangle.width, rectangle.height);
}

void fill_rectangle(const Context& context, const Rectangle& rectangle, const Colour& colour) {
  set_colour(context, colour);
  add_rectangle(context, rectangle);
  context->fill();
}

void outline_rectangle(const Context& context, const Rectangle& rectangle, const Colour& colour) {
  set_colour(context, colour);
  context->set_line_width(1.0);
  context->rectangle(rectangle.left + 0.5, rectangle.top + 0.5, rectangle.width - 1.0, rectangle.height - 1.0);
  context->stroke();
}

}  // namespace alignability::detail
