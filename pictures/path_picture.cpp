// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/path_picture.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/range.hpp"
#include "costmap/heading_layers.hpp"
#include "pictures/axes.hpp"
#include "pictures/legend.hpp"
#include "pictures/map_layers.hpp"
#include "pictures/map_layout.hpp"
#include "pictures/path_layer.hpp"
#include "pictures/profile_panel.hpp"
#include "pictures/text.hpp"

namespace alignability {
namespace {

using namespace detail;

constexpr double kPanelGap = 34.0;

void draw_key_label(const Context& context, const MapLayout& layout, const Eigen::Vector2d& line, const std::string& label) {
  const Eigen::Vector2d at = line + Eigen::Vector2d(kSampleLength + 14.0, 0.0);
  draw_text(context, label, at, {.anchor = {0.0, 0.5}, .widest = layout.width - kMargin - at.x()});
}

void draw_key(const Context& context, const MapLayout& layout, std::span<const DrawnPath> paths, const PathPictureOptions& options) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Eigen::Vector2d line = key_line(layout, options.title, i);
    draw_path_sample(context, line, paths[i]);
    draw_key_label(context, layout, line, paths[i].label);
  }
  const std::string unknown = options.risk.unknown == UnknownPolicy::risky ? " or unknown" : "";
  const Eigen::Vector2d last = key_line(layout, options.title, paths.size());
  draw_blind_sample(context, last);
  draw_key_label(context, layout, last, "blind: α below " + to_text(options.risk.alpha_critical) + unknown);
}

MapLegend risk_legend(const Grid<float>& risk) {
  const double greatest = static_cast<double>(*std::ranges::max_element(risk.values()));
  const double limit = greatest > 0.0 ? greatest : 1.0;
  return {.name = "risk",
          .colour_of = [limit](double value) { return alignability_colour(1.0 - value / limit, Tone::pale); },
          .limit = limit,
          .end = ScaleEnd::closed,
          .thresholds = {},
          .swatches = map_swatches("off the map", Tone::pale)};
}

std::vector<DrawnPath> chosen(std::span<const DrawnPath> paths, bool (*wanted)(const DrawnPath&)) {
  std::vector<DrawnPath> those;
  std::ranges::copy_if(paths, std::back_inserter(those), wanted);
  return those;
}

}  // namespace

Colour route_colour(std::size_t number) {
  constexpr std::array<Colour, kRouteColours> kColours{kShortestColour,           kRiskAwareColour,          colour_from_hex(0x8e3a9d),
                                                       colour_from_hex(0x1f6fb4), colour_from_hex(0xe8710a), colour_from_hex(0x17becf),
                                                       colour_from_hex(0x8c564b), colour_from_hex(0xd4a017)};
  return kColours[number % kRouteColours];
}

void draw_paths(const AlignabilityMap& map, const OccupancyMap& occupancy, std::span<const DrawnPath> paths,
                const PathPictureOptions& options, const std::filesystem::path& file) {
  const std::vector<DrawnPath> keyed = chosen(paths, [](const DrawnPath& path) { return !path.label.empty(); });
  const std::vector<DrawnPath> in_panel = chosen(keyed, [](const DrawnPath& path) { return !path.poses.empty(); });
  const std::size_t key_lines = paths.empty() ? 0 : keyed.size() + 1;
  const MapLayout layout = lay_out(view_of(map.geometry, occupancy), options.title, key_lines);
  const Rectangle& frame = layout.view.frame;
  const Rectangle panel{frame.left, layout.bottom + kPanelGap, frame.width, profile_height(in_panel.size())};
  const double bottom = in_panel.empty() ? layout.bottom : panel.bottom() + kBelowFrame;
  const Page page(layout.width, bottom + kMargin);
  const Context& context = page.context();

  draw_title(context, layout, options.title);
  if (!paths.empty()) draw_key(context, layout, keyed, options);
  MapLegend legend = options.risk_map ? risk_legend(*options.risk_map) : alignability_legend(options.risk, Tone::pale);
  if (!heading_layers(map).empty()) legend.name = options.risk_map ? "risk, best heading" : "α, best heading";
  draw_map(context, layout.view, options.risk_map ? *options.risk_map : best_over_headings(map), legend.colour_of, occupancy, Tone::pale);
  draw_path_layer(context, layout.view, paths, options);
  draw_axes(context, layout.view, kMapAxes);
  draw_scale_bar(context, layout.view);
  draw_map_legend(context, layout.legend, legend);
  if (!in_panel.empty()) draw_profiles(context, panel, in_panel, longest_profile(in_panel), options.risk);
  page.save(file);
}

}  // namespace alignability
