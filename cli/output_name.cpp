// SPDX-License-Identifier: BSD-3-Clause
#include "cli/output_name.hpp"

#include <algorithm>
#include <array>

namespace alignability::cli {

std::filesystem::path output_name(const std::filesystem::path& given) {
  constexpr std::array kWritten{".yaml", ".tiff", ".png", ".svg", ".pdf", ".pgm", ".json", ".csv"};
  const std::string extension = given.extension().string();
  if (std::ranges::find(kWritten, extension) == kWritten.end()) return given;
  return given.parent_path() / given.stem();
}

std::filesystem::path with_ending(const std::filesystem::path& name, const std::string& ending) { return name.string() + ending; }

std::vector<std::filesystem::path> picture_files(const std::filesystem::path& name, const PictureKinds& kinds) {
  std::vector<std::filesystem::path> files;
  for (const std::string& kind : kinds.names) files.push_back(with_ending(name, '.' + kind));
  return files;
}

}  // namespace alignability::cli
