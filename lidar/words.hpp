// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace alignability::detail {

/// What stands between blanks on a line, and where, counted from 1.
struct Word {
  std::string_view text;
  int column = 1;
};

/// Those of a line, which must outlive them.
std::vector<Word> words_of(std::string_view line);

/// The number that a word is as a whole, NaN and infinities among them; nullopt where it is none.
std::optional<double> number_of(std::string_view word);

}  // namespace alignability::detail
