// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/finished_svg.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace alignability::detail {
namespace {

bool stands_before_an_id(std::string_view text) {
  constexpr std::array<std::string_view, 3> kBefore{" id=\"", "href=\"#", "url(#"};
  return std::ranges::any_of(kBefore, [text](std::string_view before) { return text.ends_with(before); });
}

// "surface" of "surface17", "glyph0-" of "glyph0-1".
std::string_view unnumbered(std::string_view id) { return id.substr(0, id.find_last_not_of("0123456789") + 1); }

}  // namespace

std::string finished_svg(std::string_view svg) {
  std::string out;
  out.reserve(svg.size());
  std::map<std::string_view, std::string> own_ids;
  for (std::size_t at = 0; at < svg.size();) {
    out += svg[at++];
    const std::string_view before = svg.substr(0, at);
    if (before.ends_with("<image")) out += " style=\"image-rendering:pixelated\"";
    if (!stands_before_an_id(before)) continue;
    const std::string_view id = svg.substr(at, svg.find_first_of("\")", at) - at);
    const auto [entry, is_new] = own_ids.try_emplace(id, unnumbered(id));
    if (is_new) entry->second += std::to_string(own_ids.size());
    out += entry->second;
    at += id.size();
  }
  return out;
}

}  // namespace alignability::detail
