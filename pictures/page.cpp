// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/page.hpp"

#include <cmath>
#include <string>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "pictures/colour_map.hpp"
#include "pictures/finished_svg.hpp"

namespace alignability::detail {
namespace {

Cairo::Surface::SlotWriteFunc appending_to(std::string& bytes) {
  return [&bytes](const unsigned char* data, unsigned int length) {
    bytes.append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
}

}  // namespace

Page::Page(double width, double height)
    : width_(std::ceil(width)),
      height_(std::ceil(height)),
      surface_(Cairo::RecordingSurface::create(Cairo::Rectangle{0.0, 0.0, width_, height_})),
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

void Page::save(const std::filesystem::path& file) const {
  const std::string extension = file.extension().string();
  if (extension == ".png") return write_file(file, png());
  if (extension == ".svg") return write_file(file, svg());
  if (extension == ".pdf") return write_file(file, pdf());
  throw InputError(file, "a picture's name ends in .png, .svg or .pdf");
}

std::string Page::png() const {
  const auto image = Cairo::ImageSurface::create(Cairo::Surface::Format::RGB24, static_cast<int>(width_), static_cast<int>(height_));
  copy_to(image);
  std::string bytes;
  image->write_to_png_stream(appending_to(bytes));
  return bytes;
}

std::string Page::svg() const {
  std::string bytes;
  const unsigned int references = cairo_surface_get_reference_count(surface_->cobj());
  {
    const auto sheet = Cairo::SvgSurface::create_for_stream(appending_to(bytes), width_, height_);
    cairo_svg_surface_set_document_unit(sheet->cobj(), CAIRO_SVG_UNIT_PX);
    copy_to(sheet);
    sheet->finish();
  }
  // Cairo 1.16 forgets to let go of a recording that it wrote into an SVG.
  while (cairo_surface_get_reference_count(surface_->cobj()) > references) cairo_surface_destroy(surface_->cobj());
  return finished_svg(bytes);
}

std::string Page::pdf() const {
  std::string bytes;
  const auto sheet = Cairo::PdfSurface::create_for_stream(appending_to(bytes), width_, height_);
  // The time of day would make other bytes of the same picture.
  cairo_pdf_surface_set_metadata(sheet->cobj(), CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
  copy_to(sheet);
  sheet->finish();
  return bytes;
}

void Page::copy_to(const Cairo::RefPtr<Cairo::Surface>& sheet) const {
  const Context context = Cairo::Context::create(sheet);
  context->set_source(surface_, 0.0, 0.0);
  context->paint();
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
