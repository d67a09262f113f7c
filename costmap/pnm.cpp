// SPDX-License-Identifier: BSD-3-Clause
#include "costmap/pnm.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace alignability::detail {
namespace {

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

// Reads the bytes of a PNM from front to back. The formats P1 to P3 are text, P4 to P6 binary; of each kind a bitmap, grey and colour.
class PnmReader {
 public:
  explicit PnmReader(const std::string& bytes) : rest_(bytes) {
    if (rest_.size() < 3 || rest_[0] != 'P' || rest_[1] < '1' || rest_[1] > '6') throw PnmError("no PNM");
    format_ = rest_[1];
    rest_.remove_prefix(2);
    header_.width = number();
    header_.height = number();
    header_.brightest = is_bitmap() ? 1 : number();
    if (header_.brightest == 0 || header_.brightest > GreyImage::kFull) {
      throw PnmError("white is " + std::to_string(header_.brightest) + ", which must be from 1 to 65535");
    }
    if (!is_text()) next_byte();  // the one space before the pixels
  }

  const PnmHeader& header() const { return header_; }
  int channels() const { return format_ == '3' || format_ == '6' ? 3 : 1; }
  bool is_bitmap() const { return format_ == '1' || format_ == '4'; }

  void begin_row() { bits_left_ = 0; }
  // The next value, from 0 black to 65535 white.
  std::uint16_t value() {
    if (is_bitmap()) return bit() ? 0 : GreyImage::kFull;
    const std::uint64_t value = is_text() ? number() : header_.brightest > 255 ? next_two_bytes() : next_byte();
    if (value > header_.brightest) throw PnmError("a value is above " + std::to_string(header_.brightest));
    return static_cast<std::uint16_t>((2 * GreyImage::kFull * value + header_.brightest) / (2 * header_.brightest));
  }

 private:
  bool is_text() const { return format_ <= '3'; }

  std::uint8_t next_byte() {
    if (rest_.empty()) throw PnmError("it ends early");
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
    if (rest_.empty()) throw PnmError("it ends early");
  }

  std::uint64_t number() {
    skip_space_and_comments();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) throw PnmError("a number is missing or too large");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if (!rest_.empty() && !is_space(rest_.front()) && rest_.front() != '#') throw PnmError("a number is followed by something else");
    return value;
  }

  // Digits may stand together in a text; a binary row begins with a new byte.
  bool bit() {
    if (is_text()) {
      skip_space_and_comments();
      const std::uint8_t digit = next_byte();
      if (digit != '0' && digit != '1') throw PnmError("a bit is neither 0 nor 1");
      return digit == '1';
    }
    if (bits_left_ == 0) {
      bits_ = next_byte();
      bits_left_ = 8;
    }
    return (bits_ >> --bits_left_ & 1) != 0;
  }

  std::string_view rest_;
  char format_ = '0';
  PnmHeader header_{};
  std::uint8_t bits_ = 0;
  int bits_left_ = 0;
};

}  // namespace

PnmHeader read_pnm_header(const std::string& bytes) { return PnmReader(bytes).header(); }

GreyImage decode_pnm(const std::string& bytes) {
  PnmReader reader(bytes);
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
