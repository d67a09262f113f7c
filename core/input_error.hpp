// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace alignability {

/// A place in a text file, both counted from 1; 0 where a file has no lines (an image) or the fault no place (it is missing).
struct TextPosition {
  int line = 0;
  int column = 0;
};

/// What a user gave is wrong. `what()` reads like a compiler's message: `file:line:column: what is wrong, what would be right`.
class InputError : public std::runtime_error {
 public:
  InputError(std::filesystem::path file, TextPosition position, std::string_view message);
  InputError(std::filesystem::path file, std::string_view message) : InputError(std::move(file), {}, message) {}

  const std::filesystem::path& file() const { return file_; }
  TextPosition position() const { return position_; }

 private:
  std::filesystem::path file_;
  TextPosition position_;
};

/// " (did you mean 'NEAREST'?)" for the candidate that a slip of the keyboard could have turned into `word`, "" when none is that near.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace alignability
