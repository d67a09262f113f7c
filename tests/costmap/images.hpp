// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace alignability::test {

enum class PngKind { grey, grey_alpha, grey_keyed, rgb, rgba, grey16 };

/// A PNG of those channel values, 16-bit ones counting from 0 to 65535, the top row first; `gamma` above 0 is said in the file. In a keyed
/// one the shade kTransparentShade is transparent.
void write_png(const std::filesystem::path& file, PngKind kind, int width, const std::vector<int>& values, double gamma = 0.0);

inline constexpr int kTransparentShade = 254;

/// A binary PGM of 8-bit shades.
std::string pgm(int width, const std::vector<int>& shades);

}  // namespace alignability::test
