// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace alignability::detail {

/// An SVG as Cairo 1.16 writes it, with two faults mended. Ids are numbered anew in the order of their appearance: Cairo counts the
/// surfaces of the process, and the same drawing would have other bytes the second time. And images ask for sharp pixels: Cairo
/// forgets the filter, and an enlarged map would blur. O(length).
std::string finished_svg(std::string_view svg);

}  // namespace alignability::detail
