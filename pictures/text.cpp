// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/text.hpp"

#include <numbers>

namespace alignability::detail {
namespace {

constexpr double kCapitalShare = 0.73;
constexpr double kRimWidth = 5.0;

void select_font(const Context& context, double size, Weight weight) {
  context->select_font_face("sans", Cairo::ToyFontFace::Slant::NORMAL,
                            weight == Weight::bold ? Cairo::ToyFontFace::Weight::BOLD : Cairo::ToyFontFace::Weight::NORMAL);
  context->set_font_size(size);
}

double advance(const Context& context, const std::string& text) {
  Cairo::TextExtents extents;
  context->get_text_extents(text, extents);
  return extents.x_advance;
}

// Leaves the font selected and the current point where the text begins.
void move_to_begin(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style) {
  double size = style.size;
  select_font(context, size, style.weight);
  double width = advance(context, text);
  if (width > style.widest) {
    size *= style.widest / width;
    width = style.widest;
    select_font(context, size, style.weight);
  }
  context->move_to(at.x() - style.anchor.x() * width, at.y() + (1.0 - style.anchor.y()) * capital_height(size));
}

}  // namespace

void draw_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style) {
  move_to_begin(context, text, at, style);
  set_colour(context, style.colour);
  context->show_text(text);
  context->begin_new_path();
}

void draw_note(const Context& context, const std::string& text, const Eigen::Vector2d& at, const Eigen::Vector2d& anchor) {
  draw_text(context, text, at, {.size = kNoteSize, .colour = kFaintInk, .anchor = anchor});
}

void draw_rimmed_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style) {
  move_to_begin(context, text, at, style);
  context->text_path(text);
  set_colour(context, kWhite);
  context->set_line_width(kRimWidth);
  context->set_line_join(Cairo::Context::LineJoin::ROUND);
  context->stroke_preserve();
  set_colour(context, style.colour);
  context->fill();
}

void draw_upward_text(const Context& context, const std::string& text, const Eigen::Vector2d& at, const TextStyle& style) {
  context->save();
  context->translate(at.x(), at.y());
  context->rotate(-0.5 * std::numbers::pi);
  draw_text(context, text, Eigen::Vector2d::Zero(), style);
  context->restore();
}

double text_width(const std::string& text, double size, Weight weight) {
  const Context context = Page(1.0, 1.0).context();
  select_font(context, size, weight);
  return advance(context, text);
}

double capital_height(double size) { return kCapitalShare * size; }

}  // namespace alignability::detail
