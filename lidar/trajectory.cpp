// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/trajectory.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "core/file.hpp"
#include "core/input_error.hpp"
#include "core/range.hpp"
#include "lidar/words.hpp"

namespace alignability {
namespace {

using detail::Word;
using detail::words_of;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
constexpr Range kPlaces{.min = -1e7, .max = 1e7};
constexpr Range kStamps{.min = 0.0, .max = 1e15};
// Files are written with four digits and more.
constexpr double kRotationTolerance = 1e-3;

struct Line {
  std::vector<Word> words;
  int number = 0;
};

class TrajectoryReader {
 public:
  TrajectoryReader(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

  Trajectory read() {
    Trajectory trajectory{.file = file_, .format = TrajectoryFormat::tum, .poses = {}};
    while (const std::optional<Line> line = next_line()) {
      if (trajectory.poses.empty()) {
        trajectory.format = format_of(*line);
        values_ = line->words.size();
      }
      if (line->words.size() != values_) {
        fail(*line, 0,
             "there must be " + std::to_string(values_) + " values, as on the lines before, not " + std::to_string(line->words.size()));
      }
      const TrajectoryPose pose = pose_of(*line, trajectory.format, trajectory.poses.size());
      if (!trajectory.poses.empty()) check_order(*line, trajectory.format, trajectory.poses.back(), pose);
      trajectory.poses.push_back(pose);
      last_line_ = line->number;
    }
    if (trajectory.poses.empty()) throw InputError(file_, "holds no poses");
    return trajectory;
  }

 private:
  // The next that says something.
  std::optional<Line> next_line() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      std::vector<Word> words = words_of(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (!words.empty() && !words.front().text.starts_with('#')) return Line{std::move(words), line_};
    }
    return std::nullopt;
  }

  TrajectoryFormat format_of(const Line& line) const {
    switch (line.words.size()) {
      case 8:
        return TrajectoryFormat::tum;
      case 9:
        return TrajectoryFormat::numbered;
      case 12:
        return TrajectoryFormat::kitti;
      default:
        fail(line, 0,
             "a pose has 8 values (TUM: stamp x y z qx qy qz qw), 9 (the number of the scan before these) or 12 (KITTI: the upper three "
             "rows of a matrix), not " +
                 std::to_string(line.words.size()));
    }
  }

  TrajectoryPose pose_of(const Line& line, TrajectoryFormat format, std::size_t place) const {
    if (format == TrajectoryFormat::kitti) return {.stamp = 0.0, .number = place, .pose = matrix(line)};
    TrajectoryPose pose;
    std::size_t at = 0;
    if (format == TrajectoryFormat::numbered) pose.number = whole_number(line, at++);
    pose.stamp = number(line, at++, "a stamp", kStamps);
    for (int axis = 0; axis < 3; ++axis) pose.pose.translation()[axis] = number(line, at++, "a coordinate", kPlaces);
    pose.pose.linear() = rotation(line, at);
    return pose;
  }

  Eigen::Matrix3d rotation(const Line& line, std::size_t at) const {
    std::array<double, 4> xyzw;
    for (std::size_t i = 0; i < 4; ++i) xyzw[i] = number(line, at + i, "a part of a quaternion", kFinite);
    const Eigen::Quaterniond quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    if (!(std::abs(quaternion.norm() - 1.0) <= kRotationTolerance)) {
      fail(line, at, "the quaternion must be of length 1, not " + to_text(quaternion.norm()));
    }
    return quaternion.normalized().toRotationMatrix();
  }

  Eigen::Isometry3d matrix(const Line& line) const {
    Eigen::Matrix<double, 3, 4> rows;
    for (std::size_t i = 0; i < 12; ++i) {
      const bool is_place = i % 4 == 3;
      rows(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) =
          number(line, i, is_place ? "a coordinate" : "a part of a rotation", is_place ? kPlaces : kFinite);
    }
    const Eigen::Matrix3d R = rows.leftCols<3>();
    const bool is_rotation = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRotationTolerance;
    if (!is_rotation || R.determinant() < 0.0) {
      fail(line, 0, "the first three columns of the matrix must be a rotation: its rows of length 1, square to one another, right-handed");
    }
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
    pose.translation() = rows.col(3);
    return pose;
  }

  void check_order(const Line& line, TrajectoryFormat format, const TrajectoryPose& before, const TrajectoryPose& pose) const {
    if (format == TrajectoryFormat::kitti) return;
    const std::string of_before = " of line " + std::to_string(last_line_);
    const std::size_t stamp = format == TrajectoryFormat::numbered ? 1 : 0;
    if (stamp == 1 && pose.number <= before.number) {
      fail(line, 0, "the number " + std::to_string(pose.number) + " must be greater than " + std::to_string(before.number) + of_before);
    }
    if (pose.stamp <= before.stamp) {
      fail(line, stamp, "the stamp " + to_text(pose.stamp) + " must be later than " + to_text(before.stamp) + of_before);
    }
  }

  double number(const Line& line, std::size_t at, const char* what, const Range& allowed) const {
    const auto value = detail::number_of(line.words[at].text);
    if (value && allowed.contains(*value)) return *value;
    std::string message = what;
    message += " must be ";
    message += value ? allowed.description() : "a number";
    message += ", not '";
    message += line.words[at].text;
    fail(line, at, message += '\'');
  }

  std::uint64_t whole_number(const Line& line, std::size_t at) const {
    const std::string_view text = line.words[at].text;
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return value;
    std::string message = "of 9 values the first is the number of the scan, a whole one, not '";
    message += text;
    fail(line, at, message += '\'');
  }

  [[noreturn]] void fail(const Line& line, std::size_t word, std::string_view message) const {
    throw InputError(file_, {line.number, line.words[word].column}, message);
  }

  std::string_view text_;
  const std::filesystem::path& file_;
  int line_ = 0;
  int last_line_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

Trajectory read_trajectory(const std::filesystem::path& file) { return parse_trajectory(read_file(file, kLargestFile), file); }

Trajectory parse_trajectory(std::string_view text, const std::filesystem::path& file) { return TrajectoryReader(text, file).read(); }

}  // namespace alignability
