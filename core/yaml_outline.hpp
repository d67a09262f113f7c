// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace alignability::detail {

/// Throws InputError where text is no YAML, has a second document, or nests more than kDeepestYaml deep: before yaml-cpp, as Debian 12 has
/// it, makes nodes of it, which for some texts without a meaning never ends.
void check_yaml_outline(const std::string& text, const std::filesystem::path& file);

inline constexpr int kDeepestYaml = 64;

}  // namespace alignability::detail
