// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alignability::cli {

/// The NAME of `-o NAME`: an extension that this program writes is dropped, any other dot stays part of the name.
std::filesystem::path output_name(const std::filesystem::path& given);

/// NAME with something put after it, dots in NAME untouched.
std::filesystem::path with_ending(const std::filesystem::path& name, const std::string& ending);

/// What pictures are written as.
struct PictureKinds {
  std::vector<std::string> names{"png"};  ///< of png, svg and pdf
};

/// NAME.png, NAME.svg or NAME.pdf: the files of one picture.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& name, const PictureKinds& kinds);

}  // namespace alignability::cli
