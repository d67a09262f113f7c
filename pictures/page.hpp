// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cairomm/cairomm.h>

#include <filesystem>
#include <string>

#include "pictures/colour.hpp"

namespace alignability::detail {

using Context = Cairo::RefPtr<Cairo::Context>;

/// A part of a page [px], y down.
struct Rectangle {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// A white sheet to draw on.
class Page {
 public:
  Page(double width, double height);

  const Context& context() const { return context_; }
  /// A PNG, an SVG or a PDF, as the name's extension says; the same drawing gives the same bytes. Throws InputError when it says none of
  /// these or the file cannot be written; then what stood there stays.
  void save(const std::filesystem::path& file) const;

 private:
  std::string png() const;
  std::string svg() const;
  std::string pdf() const;
  void copy_to(const Cairo::RefPtr<Cairo::Surface>& sheet) const;

  double width_;   // [px], whole
  double height_;  // [px], whole
  Cairo::RefPtr<Cairo::RecordingSurface> surface_;
  Context context_;
};

void set_colour(const Context& context, const Colour& colour);
void set_colour(const Context& context, const Colour& colour, double opacity);
void add_rectangle(const Context& context, const Rectangle& rectangle);
void fill_rectangle(const Context& context, const Rectangle& rectangle, const Colour& colour);
/// A hairline on whole pixels along the inside of the rectangle's edge.
void outline_rectangle(const Context& context, const Rectangle& rectangle, const Colour& colour);

}  // namespace alignability::detail
