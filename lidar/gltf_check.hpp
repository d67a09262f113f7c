// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace alignability::detail {

/// Sees that a glTF file, text or binary, is of version 2, needs no compression to be unpacked, and gives positions and corners in types
/// that the standard allows, which the importer does not ask: it takes what else is there for them. Throws InputError.
void check_gltf(std::string_view bytes, const std::filesystem::path& file);

}  // namespace alignability::detail
