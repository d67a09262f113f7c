// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace alignability::detail {

/// The SDF file that a URI of an `<include>` stands for, and nothing when there is none.
using FindModel = std::function<std::optional<std::filesystem::path>(const std::string& uri)>;

/// Sees that a file and whatever it includes, at any depth, is XML whose root is an `<sdf>` of a version that is read, is there, and does
/// not include itself. Throws InputError at the line that is wrong. libsdformat is less exact, and overflows the stack on the last.
void check_includes(const std::filesystem::path& file, const FindModel& find_model);

}  // namespace alignability::detail
