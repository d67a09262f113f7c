// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/carmen_log.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "core/range.hpp"
#include "lidar/words.hpp"

namespace alignability {
namespace {

using detail::Word;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
constexpr double kMostBeams = 1 << 16;
constexpr double kLeastCode = 81.83;
constexpr Range kCounts{.min = 1.0, .max = kMostBeams};
constexpr Range kRemissions{.min = 0.0, .max = kMostBeams};
constexpr Range kPlaces{.min = -1e7, .max = 1e7};
constexpr Range kTurn{.min = -4.0 * std::numbers::pi, .max = 4.0 * std::numbers::pi};

// The words of a line, taken one after the other.
class LineReader {
 public:
  LineReader(std::vector<Word> words, int line, const std::filesystem::path& file) : words_(std::move(words)), line_(line), file_(file) {}

  double number(const char* what, const Range& allowed) {
    if (next_ == words_.size()) {
      std::string message = "the line ends where ";
      fail(words_.size() - 1, (message += what) += " must follow");
    }
    const auto value = detail::number_of(words_[next_].text);
    if (value && allowed.contains(*value)) {
      ++next_;
      return *value;
    }
    std::string message = what;
    message += " must be ";
    message += value ? allowed.description() : "a number";
    message += ", not '";
    message += words_[next_].text;
    fail(next_, message += '\'');
  }

  // That so many values follow which the line can hold, too.
  std::size_t count(const char* what, const Range& allowed) {
    const std::size_t at = next_;
    const double value = number(what, allowed);
    if (value != std::floor(value)) fail(at, std::string(what) + " must be a whole number");
    const auto whole = static_cast<std::size_t>(value);
    if (whole <= words_.size() - next_) return whole;
    std::string message = what;
    message += " is " + std::to_string(whole);
    fail(at, message += ", but only " + std::to_string(words_.size() - next_) + " values follow");
  }

  std::size_t left() const { return words_.size() - next_; }

  [[noreturn]] void fail_length(std::size_t wanted) const {
    std::string message = "after the ranges " + std::to_string(wanted);
    fail(0, message += " values must follow, not " + std::to_string(left()));
  }

  void skip(std::size_t count) { next_ += count; }

 private:
  [[noreturn]] void fail(std::size_t word, const std::string& message) const {
    throw InputError(file_, {line_, words_[word].column}, message);
  }

  std::vector<Word> words_;
  int line_;
  const std::filesystem::path& file_;
  std::size_t next_ = 1;  // the first names the message
};

struct Beams {
  double first = 0.0;  // [rad] counter-clockwise from ahead
  double step = 0.0;
  double nothing_from = 0.0;  // [m] what is said of beams without a return
};

Scan scan_of(LineReader& line, const Beams& beams, std::size_t count) {
  Scan scan{.points = {}, .rings = 1, .columns = static_cast<int>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double range = line.number("a range", kNotNegative);
    const double azimuth = beams.first + beams.step * static_cast<double>(i);
    const bool seen = range > 0.0 && range < beams.nothing_from;
    const double counted = seen ? range : std::numeric_limits<double>::quiet_NaN();
    scan.points.push_back((counted * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0)).cast<float>());
    if (!seen) scan.points.back().setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

Eigen::Isometry3d pose_of(LineReader& line) {
  const double x = line.number("a coordinate", kPlaces);
  const double y = line.number("a coordinate", kPlaces);
  const double yaw = line.number("a heading", kFinite);
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

// The rest of the line is the odometry's pose, and when and by whom it was written.
PosedScan read_flaser(LineReader line) {
  constexpr std::size_t kAfterRanges = 9;
  const std::size_t count = line.count("the count of beams", kCounts);
  const std::size_t steps = count % 2 == 1 && count > 1 ? count - 1 : count;
  PosedScan posed;
  posed.scan = scan_of(line, {-0.5 * std::numbers::pi, std::numbers::pi / static_cast<double>(steps), kLeastCode}, count);
  if (line.left() != kAfterRanges) line.fail_length(kAfterRanges);
  posed.T_map_lidar = pose_of(line);
  line.skip(3);
  posed.stamp = line.number("a stamp", kFinite);
  return posed;
}

PosedScan read_robotlaser(LineReader line) {
  constexpr std::size_t kAfterRemissions = 14;
  Beams beams;
  line.number("the type of the lidar", kFinite);
  beams.first = line.number("the first angle", kTurn);
  line.number("the field of view", kTurn);
  beams.step = line.number("the step between beams", kTurn);
  beams.nothing_from = line.number("the largest range", kPositive);
  line.number("the accuracy", kFinite);
  line.number("the mode of remissions", kFinite);
  PosedScan posed;
  posed.scan = scan_of(line, beams, line.count("the count of beams", kCounts));
  line.skip(line.count("the count of remissions", kRemissions));
  if (line.left() != kAfterRemissions) line.fail_length(kAfterRemissions);
  posed.T_map_lidar = pose_of(line);
  line.skip(8);
  posed.stamp = line.number("a stamp", kFinite);
  return posed;
}

}  // namespace

bool is_carmen_log(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".log" || ending == ".clf";
}

std::vector<PosedScan> read_carmen_log(const std::filesystem::path& file) { return parse_carmen_log(read_file(file, kLargestFile), file); }

std::vector<PosedScan> parse_carmen_log(std::string_view text, const std::filesystem::path& file) {
  std::vector<PosedScan> scans;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::vector<Word> words = detail::words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty()) continue;
    const std::string_view message = words.front().text;
    const bool robotlaser = message == "ROBOTLASER1";
    if (!robotlaser && message != "FLASER") continue;
    LineReader line(std::move(words), number, file);
    scans.push_back(robotlaser ? read_robotlaser(std::move(line)) : read_flaser(std::move(line)));
    scans.back().file = file;
    scans.back().file += ":" + std::to_string(number);
  }
  if (scans.empty()) throw InputError(file, "holds no scans: lines that begin with FLASER or ROBOTLASER1");
  return scans;
}

}  // namespace alignability
