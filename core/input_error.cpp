// SPDX-License-Identifier: BSD-3-Clause
#include "core/input_error.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace alignability {
namespace {

std::string located(const std::filesystem::path& file, TextPosition position, std::string_view message) {
  std::string text = file.string();
  if (position.line > 0) text += ':' + std::to_string(position.line);
  if (position.line > 0 && position.column > 0) text += ':' + std::to_string(position.column);
  return text.append(": ").append(message);
}

// Letters to insert, delete, replace or swap with the next to get from one word to the other (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

InputError::InputError(std::filesystem::path file, TextPosition position, std::string_view message)
    : std::runtime_error(located(file, position, message)), file_(std::move(file)), position_(position) {}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kLongestWord = 64;
  constexpr std::size_t kLettersPerSlip = 3;  // so that 'max' is no slip for 'min'
  if (word.size() > kLongestWord) return {};
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / kLettersPerSlip) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least || distance >= candidate.size()) continue;
    least = distance;
    nearest = &candidate;
  }
  return nearest == nullptr ? std::string{} : " (did you mean '" + *nearest + "'?)";
}

}  // namespace alignability
