// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scan_log.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/input_error.hpp"
#include "core/range.hpp"
#include "lidar/scan_file.hpp"

namespace alignability {
namespace {

namespace fs = std::filesystem;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_scan(const fs::path& file) {
  constexpr std::array kEndings{".pcd", ".ply", ".bin"};
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

// Runs of digits count by their value, all else by its letters.
bool counts_before(std::string_view a, std::string_view b) {
  const auto take_digits = [](std::string_view& text) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view digits = text.substr(0, end);
    text.remove_prefix(end);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
  };
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view digits_a = take_digits(a), digits_b = take_digits(b);
      if (digits_a.size() != digits_b.size()) return digits_a.size() < digits_b.size();
      if (digits_a != digits_b) return digits_a < digits_b;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() != b.size() ? a.size() < b.size() : whole_a < whole_b;
}

std::vector<fs::path> scans_in(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw InputError(folder, "cannot be read as a folder of scans: " + error.message());
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries) {
    if (is_scan(entry.path()) && entry.is_regular_file(error)) files.push_back(entry.path());
  }
  if (files.empty()) throw InputError(folder, "has no scans: files that end in .pcd, .ply or .bin");
  std::ranges::sort(files, counts_before, [](const fs::path& file) { return file.filename().string(); });
  return files;
}

// The last number in a file's name, its ending aside: "scan_12.500" of scan_12.500.pcd has 12.500.
std::string number_in_name(const fs::path& file) {
  const std::string name = file.stem().string();
  const std::size_t last = name.find_last_of("0123456789");
  if (last == std::string::npos) throw InputError(file, "has no number in its name by which to find its pose");
  std::size_t begin = last;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  if (begin > 1 && name[begin - 1] == '.' && is_digit(name[begin - 2])) {
    --begin;
    while (begin > 0 && is_digit(name[begin - 1])) --begin;
  }
  return name.substr(begin, last + 1 - begin);
}

// In seconds.
double stamp_in_name(const fs::path& file) {
  const std::string text = number_in_name(file);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  // Seconds since 1970 stay below the first for three thousand years, and each finer unit within its own.
  constexpr std::array<std::pair<double, double>, 3> kUnits{{{1e17, 1e-9}, {1e14, 1e-6}, {1e11, 1e-3}}};
  for (const auto& [from, seconds] : kUnits) {
    if (value >= from) return value * seconds;
  }
  return value;
}

std::uint64_t whole_number_in_name(const fs::path& file) {
  const std::string text = number_in_name(file);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  throw InputError(file, "has " + text + " in its name, where the number of a pose is a whole one");
}

template <typename Number>
void refuse_repeated(const std::vector<fs::path>& files, const std::vector<Number>& numbers) {
  std::map<Number, std::size_t> first;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto [found, is_new] = first.emplace(numbers[i], i);
    if (!is_new) throw InputError(files[i], "has the same number in its name as " + files[found->second].filename().string());
  }
}

template <typename Number>
std::vector<Number> numbers_of(const std::vector<fs::path>& files, Number (*number_of)(const fs::path&)) {
  std::vector<Number> numbers;
  for (const fs::path& file : files) numbers.push_back(number_of(file));
  refuse_repeated(files, numbers);
  return numbers;
}

Eigen::Isometry3d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double share) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(from.linear()).slerp(share, Eigen::Quaterniond(to.linear())).toRotationMatrix();
  pose.translation() = (1.0 - share) * from.translation() + share * to.translation();
  return pose;
}

// Of poses by stamp, ascending; nullopt where none is near enough.
std::optional<Eigen::Isometry3d> pose_at(const std::vector<TrajectoryPose>& poses, double stamp, double max_gap) {
  const auto after = std::ranges::lower_bound(poses, stamp, {}, &TrajectoryPose::stamp);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const double gap_after = after == poses.end() ? kFar : after->stamp - stamp;
  const double gap_before = after == poses.begin() ? kFar : stamp - std::prev(after)->stamp;
  if (std::min(gap_before, gap_after) > max_gap) return std::nullopt;
  if (gap_after == kFar || gap_before == kFar) return gap_after == kFar ? std::prev(after)->pose : after->pose;
  return between(std::prev(after)->pose, after->pose, gap_before / (gap_before + gap_after));
}

class Pairer {
 public:
  Pairer(std::vector<fs::path> files, const Trajectory& trajectory) : files_(std::move(files)), trajectory_(trajectory) {}

  ScanLog by_order() const {
    const auto& poses = trajectory_.poses;
    if (poses.size() != files_.size()) {
      throw InputError(trajectory_.file, "has " + std::to_string(poses.size()) + " poses for the " + std::to_string(files_.size()) +
                                             " scans in " + folder() + "; paired by order, there must be as many");
    }
    ScanLog log{.pairing = Pairing::order, .scans = {}, .without_a_pose = {}};
    for (std::size_t i = 0; i < files_.size(); ++i) log.scans.push_back({files_[i], poses[i].stamp, poses[i].pose, {}});
    return log;
  }

  ScanLog by_number() const {
    if (trajectory_.format == TrajectoryFormat::tum) {
      throw InputError(trajectory_.file, "has stamps, not numbers of scans, to pair by");
    }
    const auto numbers = numbers_of(files_, whole_number_in_name);
    ScanLog log{.pairing = Pairing::number, .scans = {}, .without_a_pose = {}};
    for (std::size_t i = 0; i < files_.size(); ++i) {
      const auto found = std::ranges::lower_bound(trajectory_.poses, numbers[i], {}, &TrajectoryPose::number);
      if (found == trajectory_.poses.end() || found->number != numbers[i]) {
        log.without_a_pose.push_back(files_[i]);
      } else {
        log.scans.push_back({files_[i], found->stamp, found->pose, {}});
      }
    }
    if (log.scans.empty()) {
      fail_far(std::to_string(numbers.front()), std::to_string(numbers.back()), std::to_string(trajectory_.poses.front().number),
               std::to_string(trajectory_.poses.back().number), "has no pose of the number of any scan");
    }
    return log;
  }

  ScanLog by_stamp(double max_gap) const {
    if (trajectory_.format == TrajectoryFormat::kitti) throw InputError(trajectory_.file, "has no stamps to pair by");
    const auto stamps = numbers_of(files_, stamp_in_name);
    ScanLog log{.pairing = Pairing::stamp, .scans = {}, .without_a_pose = {}};
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (const auto pose = pose_at(trajectory_.poses, stamps[i], max_gap)) {
        log.scans.push_back({files_[i], stamps[i], *pose, {}});
      } else {
        log.without_a_pose.push_back(files_[i]);
      }
    }
    if (log.scans.empty()) {
      fail_far(to_text(stamps.front()), to_text(stamps.back()), to_text(trajectory_.poses.front().stamp),
               to_text(trajectory_.poses.back().stamp), "has no pose within " + to_text(max_gap) + " s of any scan");
    }
    return log;
  }

 private:
  std::string folder() const { return files_.front().parent_path().string(); }

  [[noreturn]] void fail_far(const std::string& first_scan, const std::string& last_scan, const std::string& first_pose,
                             const std::string& last_pose, const std::string& what) const {
    std::string message = what;
    message += " in " + folder();
    message += ": by their names these are from " + first_scan;
    message += " (" + files_.front().filename().string();
    message += ") to " + last_scan;
    message += ", poses from " + first_pose;
    message += " to " + last_pose;
    throw InputError(trajectory_.file, message);
  }

  std::vector<fs::path> files_;
  const Trajectory& trajectory_;
};

Pairing usual_pairing(TrajectoryFormat format) {
  switch (format) {
    case TrajectoryFormat::tum:
      return Pairing::stamp;
    case TrajectoryFormat::numbered:
      return Pairing::number;
    case TrajectoryFormat::kitti:
      break;
  }
  return Pairing::order;
}

ScanLog paired(const Pairer& pairer, Pairing pairing, double max_gap) {
  switch (pairing) {
    case Pairing::stamp:
      return pairer.by_stamp(max_gap);
    case Pairing::number:
      return pairer.by_number();
    case Pairing::order:
    case Pairing::none:
      break;
  }
  return pairer.by_order();
}

}  // namespace

ScanLog read_scan_log(const fs::path& folder, const Trajectory& trajectory, const ScanLogOptions& options) {
  const Pairer pairer(scans_in(folder), trajectory);
  ScanLog log = paired(pairer, options.pairing.value_or(usual_pairing(trajectory.format)), options.max_gap);
  if (options.frame == TrajectoryFrame::base_link) {
    for (PosedScan& scan : log.scans) scan.T_map_lidar = scan.T_map_lidar * options.T_base_lidar;
  }
  return log;
}

std::string_view to_string(Pairing pairing) {
  switch (pairing) {
    case Pairing::stamp:
      return "stamp";
    case Pairing::number:
      return "number";
    case Pairing::none:
      return "none";
    case Pairing::order:
      break;
  }
  return "order";
}

Scan scan_of(const PosedScan& posed) { return posed.scan ? *posed.scan : read_scan_file(posed.file); }

Scan cropped(Scan scan, double range_max) {
  const auto squared = static_cast<float>(range_max * range_max);
  for (Eigen::Vector3f& point : scan.points) {
    if (point.squaredNorm() > squared) point.setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

}  // namespace alignability
