// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace alignability::detail {

/// Sees that a COLLADA file is XML; that no number in an attribute (`count`, `stride`, `offset`, …) is larger than the file has bytes, as
/// the importer allocates what they promise; and that what the importer would replace in silence is right: the unit, the up axis, and the
/// geometries that nodes refer to. Throws InputError at the line and column that are wrong.
void check_collada(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
