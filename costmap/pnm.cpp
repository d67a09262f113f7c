// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/pnm.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

constexpr std::size_t kLongestShown = 40;

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

// Reads the bytes of a PNM from front to back. The formats P1 to P3 are text, P4 to P6 binary; of each kind a bitmap, grey and colour.
class PnmReader {
 public:
  PnmReader(const std::string& bytes, const std::filesystem::path& file) : file_(file), whole_(bytes), rest_(bytes) {
    format_ = rest_[1];
    rest_.remove_prefix(2);
    header_.width = number();
    header_.height = number();
    header_.brightest = is_bitmap() ? 1 : number();
    if (header_.brightest == 0 || header_.brightest > GreyImage::kFull) {
      fail("white must be from 1 to 65535, not " + std::to_string(header_.brightest));
    }
    if (!is_text()) next_byte();  // the one space before the pixels
    in_pixels_ = true;
  }

  const PnmHeader& header() const { return header_; }
  int channels() const { return format_ == '3' || format_ == '6' ? 3 : 1; }
  bool is_bitmap() const { return format_ == '1' || format_ == '4'; }

  void begin_row() { bits_left_ = 0; }
  // The next value, from 0 black to 65535 white.
  std::uint16_t value() {
    if (is_bitmap()) return bit() ? 0 : GreyImage::kFull;
    const std::uint64_t value = is_text() ? number() : header_.brightest > 255 ? next_two_bytes() : next_byte();
    if (value > header_.brightest) fail(std::to_string(value) + " is above white, " + std::to_string(header_.brightest));
    return static_cast<std::uint16_t>((2 * GreyImage::kFull * value + header_.brightest) / (2 * header_.brightest));
  }

 private:
  bool is_text() const { return format_ <= '3'; }

  // At what was read last; binary pixels have no lines.
  [[noreturn]] void fail(const std::string& message) const {
    if (in_pixels_ && !is_text()) throw InputError(file_, message);
    const std::string_view before = whole_.substr(0, last_);
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 without one
    const auto line = 1 + std::ranges::count(before, '\n');
    throw InputError(file_, {static_cast<int>(line), static_cast<int>(1 + last_ - line_begin)}, message);
  }

  std::uint8_t next_byte() {
    last_ = whole_.size() - rest_.size();
    if (rest_.empty()) fail("ends early");
    const char byte = rest_.front();
    rest_.remove_prefix(1);
    return static_cast<std::uint8_t>(byte);
  }

  std::uint64_t next_two_bytes() {
    const std::uint64_t high = next_byte();
    return 256 * high + next_byte();
  }

  void skip_space_and_comments() {
    while (!rest_.empty() && (is_space(rest_.front()) || rest_.front() == '#')) {
      rest_.remove_prefix(rest_.front() == '#' ? std::min(rest_.find('\n'), rest_.size()) : 1);
    }
    last_ = whole_.size() - rest_.size();
    if (rest_.empty()) fail("ends early");
  }

  std::uint64_t number() {
    skip_space_and_comments();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    const auto word_end = std::ranges::find_if(rest_, [](char letter) { return is_space(letter) || letter == '#'; });
    const std::string_view word(rest_.begin(), word_end);
    if (error != std::errc{} || end != word.data() + word.size()) fail("'" + std::string(word.substr(0, kLongestShown)) + "' is no number");
    rest_.remove_prefix(word.size());
    return value;
  }

  // Digits may stand together in a text; a binary row begins with a new byte.
  bool bit() {
    if (is_text()) {
      skip_space_and_comments();
      const std::uint8_t digit = next_byte();
      if (digit != '0' && digit != '1') fail("a bit is neither 0 nor 1");
      return digit == '1';
    }
    if (bits_left_ == 0) {
      bits_ = next_byte();
      bits_left_ = 8;
    }
    return (bits_ >> --bits_left_ & 1) != 0;
  }

  const std::filesystem::path& file_;
  std::string_view whole_;
  std::string_view rest_;
  std::size_t last_ = 0;  // where what was read last begins
  bool in_pixels_ = false;
  char format_ = '0';
  PnmHeader header_{};
  std::uint8_t bits_ = 0;
  int bits_left_ = 0;
};

}  // namespace

PnmHeader read_pnm_header(const std::string& bytes, const std::filesystem::path& file) { return PnmReader(bytes, file).header(); }

GreyImage decode_pnm(const std::string& bytes, const std::filesystem::path& file) {
  PnmReader reader(bytes, file);
  GreyImage image{static_cast<int>(reader.header().width), static_cast<int>(reader.header().height), {}, false};
  image.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row) {
    reader.begin_row();
    for (int x = 0; x < image.width; ++x) {
      const std::uint16_t first = reader.value();
      const bool coloured = reader.channels() == 3;
      const std::uint16_t second = coloured ? reader.value() : first;
      const std::uint16_t third = coloured ? reader.value() : first;
      image.rgba.insert(image.rgba.end(), {first, second, third, GreyImage::kFull});
    }
  }
  return image;
}

}  // namespace alignability::detail
