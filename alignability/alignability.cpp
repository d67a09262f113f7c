// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/alignability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "alignability/information.hpp"
#include "alignability/merged_planes.hpp"
#include "alignability/segment_shape.hpp"
#include "alignability/segmenter.hpp"
#include "core/range.hpp"
#include "lidar/thinning.hpp"

namespace alignability {
namespace {

// Goes up whenever the same scan would score otherwise, if only in the last bit: cells of different revisions do not mix.
constexpr int kEngineRevision = 2;

// Σ n and Σ nnᵀ of the normals that vote.
struct NormalSums {
  double count = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& normal, double times = 1.0) {
    count += times;
    first += times * normal;
    second += times * normal * normal.transpose();
  }

  Eigen::Matrix3d moment(Moment moment) const {
    if (count == 0.0) return Eigen::Matrix3d::Zero();
    if (moment == Moment::about_origin) return second / count;
    return second / count - first * first.transpose() / (count * count);
  }
};

// λ_min/λ_max of a second moment, whose eigenvalues ascend.
double ratio(double least, double largest) { return largest > 0.0 ? std::clamp(least / largest, 0.0, 1.0) : 0.0; }

double ratio(const Eigen::Matrix3d& moment, Dimensions dimensions) {
  if (dimensions == Dimensions::two) {
    const Eigen::Matrix2d level = moment.topLeftCorner<2, 2>();
    const Eigen::Vector2d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(level, Eigen::EigenvaluesOnly).eigenvalues();
    return ratio(eigenvalues[0], eigenvalues[1]);
  }
  const Eigen::Vector3d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment, Eigen::EigenvaluesOnly).eigenvalues();
  return ratio(eigenvalues[0], eigenvalues[2]);
}

void set_moment(ScoredScan& scored, const Eigen::Matrix3d& moment) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moment);
  Alignability& result = scored.alignability;
  scored.axes = solver.eigenvectors().rowwise().reverse();
  result.eigenvalues = solver.eigenvalues().reverse().cwiseMax(0.0);
  result.weakest_direction = solver.eigenvectors().col(0);
  result.alpha = ratio(solver.eigenvalues()[0], solver.eigenvalues()[2]);
}

void set_level_moment(ScoredScan& scored, const Eigen::Matrix2d& moment) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moment);
  Alignability& result = scored.alignability;
  scored.axes.setIdentity();
  scored.axes.topLeftCorner<2, 2>() = solver.eigenvectors().rowwise().reverse();
  result.eigenvalues << solver.eigenvalues().reverse().cwiseMax(0.0), std::numeric_limits<double>::quiet_NaN();
  result.weakest_direction << solver.eigenvectors().col(0), 0.0;
  result.alpha = ratio(solver.eigenvalues()[0], solver.eigenvalues()[1]);
}

}  // namespace

bool AlignabilityOptions::wants(Reading reading) const { return std::ranges::find(readings, reading) != readings.end(); }

AlignabilityOptions for_lidar(AlignabilityOptions options, const SensorRig& sensor) {
  options.segmentation.range_min = sensor.range_min();
  options.segmentation.dimensions = sensor.is_planar() ? Dimensions::two : Dimensions::three;
  if (sensor.range_stddev() > 0.0) options.range_stddev = sensor.range_stddev();
  options.T_base_scan = sensor.T_base_scan();
  return options;
}

class Scorer::Implementation {
 public:
  explicit Implementation(const AlignabilityOptions& options) : options_(options) {
    const SegmentationOptions& segmentation = options.segmentation;
    if (segmentation.stride < 1 || segmentation.stride > kMostStride) throw std::invalid_argument("the stride must be 1 to 4");
    if (segmentation.stride > 1 && segmentation.engine == Engine::pcl) throw std::invalid_argument("the engine pcl knows no stride");
    if (segmentation.dimensions == Dimensions::two && segmentation.engine == Engine::pcl) {
      throw std::invalid_argument("the engine pcl knows no scans of two dimensions");
    }
    if (segmentation.normal_neighbours < 3) throw std::invalid_argument("a normal takes at least 3 neighbours");
    if (segmentation.growing_neighbours < 1) throw std::invalid_argument("growing takes at least 1 neighbour");
    for (const Reading reading : options.readings) {
      if (std::ranges::count(options.readings, reading) > 1) throw std::invalid_argument("a reading is asked for twice");
    }
    if (!kPositive.contains(options.voxel)) throw std::invalid_argument("the voxel must be greater than 0");
    if (!kPositive.contains(options.range_stddev)) throw std::invalid_argument("range_stddev must be greater than 0");
  }

  // Calls `on_plane` with the members of each plane that is kept.
  template <typename OnPlane>
  ScoredScan score(const Scan& scan, OnPlane on_plane) {
    const Dimensions dimensions = detail::resolved_dimensions(scan, options_.segmentation);
    // Before the scan itself, whose segmentation must last.
    const double voxel = options_.wants(Reading::voxel) ? voxel_alpha(scan, dimensions) : Readings::kNone;
    const Segmentation& segmentation = segment(scan, dimensions);
    ScoredScan scored;
    scored.alignability.points = segmentation.points;
    scored.alignability.dimensions = dimensions == Dimensions::two ? 2 : 3;
    NormalSums sums;
    std::vector<std::vector<std::int32_t>> kept;
    const bool merges = options_.wants(Reading::robust) || options_.wants(Reading::information);
    for_each_plane(scan, segmentation, scored.alignability, [&](std::span<const std::int32_t> members, int plane) {
      add_normals(sums, segmentation, members);
      if (merges) kept.emplace_back(members.begin(), members.end());
      on_plane(members, plane);
    });
    const Eigen::Matrix3d moment = sums.moment(options_.moment);
    if (sums.count > 0.0 && dimensions == Dimensions::three) set_moment(scored, moment);
    if (sums.count > 0.0 && dimensions == Dimensions::two) set_level_moment(scored, moment.topLeftCorner<2, 2>());
    Readings& readings = scored.alignability.readings;
    readings.voxel = voxel;
    if (options_.wants(Reading::centred)) readings.centred = ratio(sums.moment(Moment::about_mean), dimensions);
    if (merges) {
      const bool organized = scan.parts.empty() ? scan.organized() : scan.parts.front().rings > 1;
      const int points_a_vote = organized ? options_.segmentation.stride : 1;
      read_planes(readings, detail::merged_planes(scan, std::move(kept), segmentation.normals, dimensions, options_.range_stddev),
                  points_a_vote, dimensions);
    }
    return scored;
  }

  // Of the scan scored last.
  const Segmentation& segmentation() const { return segmenter_.last(); }

 private:
  const Segmentation& segment(const Scan& scan, Dimensions dimensions) {
    SegmentationOptions options = options_.segmentation;
    options.dimensions = dimensions;
    return segmenter_.segment(scan, options);
  }

  bool is_plane(const detail::SegmentShape& shape, int dimensions) const {
    return (dimensions == 2 ? shape.straightness() : shape.flatness()) < options_.plane_threshold;
  }

  bool is_large(const detail::SegmentShape& shape, int dimensions) const {
    return dimensions == 2 ? shape.extents[1] > options_.min_length : shape.area() > options_.min_area;
  }

  template <typename OnPlane>
  void for_each_plane(const Scan& scan, const Segmentation& segmentation, Alignability& result, OnPlane on_plane) const {
    for (std::size_t segment = 0; segment < segmentation.segments(); ++segment) {
      const auto members = segmentation.segment(segment);
      const detail::SegmentShape shape = result.dimensions == 2 ? detail::line_shape_of(scan, members) : detail::shape_of(scan, members);
      if (!is_plane(shape, result.dimensions)) continue;
      ++result.planes_found;
      if (is_large(shape, result.dimensions)) on_plane(members, result.planes_kept++);
    }
  }

  static void add_normals(NormalSums& sums, const Segmentation& segmentation, std::span<const std::int32_t> members) {
    for (const std::int32_t i : members) {
      const Eigen::Vector3f& normal = segmentation.normals[static_cast<std::size_t>(i)];
      if (normal.allFinite()) sums.add(normal.cast<double>());
    }
  }

  double voxel_alpha(const Scan& scan, Dimensions dimensions) {
    const Scan thin = thinned_scan(scan);
    const Segmentation& segmentation = segment(thin, dimensions);
    Alignability result;
    result.dimensions = dimensions == Dimensions::two ? 2 : 3;
    NormalSums sums;
    for_each_plane(thin, segmentation, result,
                   [&](std::span<const std::int32_t> members, int) { add_normals(sums, segmentation, members); });
    return ratio(sums.moment(Moment::about_origin), dimensions);
  }

  // Each lidar's points on their own.
  Scan thinned_scan(const Scan& scan) const {
    Scan thin;
    for (const ScanPart& part : scan.parts) {
      const std::vector<Eigen::Vector3f> own = thinned_points(detail::own_scan(scan, part));
      thin.parts.push_back({thin.points.size(), 1, static_cast<int>(own.size()), part.T_scan_lidar});
      const Eigen::Isometry3f T_scan_lidar = part.T_scan_lidar.cast<float>();
      for (const Eigen::Vector3f& point : own) thin.points.emplace_back(T_scan_lidar * point);
    }
    if (scan.parts.empty()) thin.points = thinned_points(scan);
    thin.columns = static_cast<int>(thin.points.size());
    return thin;
  }

  std::vector<Eigen::Vector3f> thinned_points(const Scan& scan) const {
    std::vector<Eigen::Vector3f> counted;
    for (const Eigen::Vector3f& point : scan.points) {
      if (detail::counts(point, options_.segmentation.range_min)) counted.push_back(point);
    }
    return thinned(counted, options_.voxel);
  }

  void read_planes(Readings& readings, const std::vector<detail::MergedPlane>& planes, int points_a_vote, Dimensions dimensions) const {
    if (options_.wants(Reading::robust)) {
      NormalSums sums;
      for (const detail::MergedPlane& plane : planes) {
        if (!plane.is_strip) sums.add(plane.own_normal, plane.count());
      }
      readings.robust = ratio(sums.moment(Moment::about_origin), dimensions);
    }
    if (options_.wants(Reading::information)) {
      readings.information = detail::planar_information(planes, options_.T_base_scan, options_.range_stddev, points_a_vote);
    }
  }

  AlignabilityOptions options_;
  detail::Segmenter segmenter_;
};

Scorer::Scorer(const AlignabilityOptions& options) : implementation_(std::make_unique<Implementation>(options)) {}
Scorer::Scorer(Scorer&&) noexcept = default;
Scorer& Scorer::operator=(Scorer&&) noexcept = default;
Scorer::~Scorer() = default;

Alignability Scorer::alignability(const Scan& scan) {
  return implementation_->score(scan, [](std::span<const std::int32_t>, int) {}).alignability;
}

ScoredScan Scorer::score(const Scan& scan) {
  std::vector<int> plane_of_point(scan.points.size(), -1);
  ScoredScan scored = implementation_->score(scan, [&](std::span<const std::int32_t> members, int plane) {
    for (const std::int32_t i : members) plane_of_point[static_cast<std::size_t>(i)] = plane;
  });
  scored.plane_of_point = std::move(plane_of_point);
  scored.normals = implementation_->segmentation().normals;
  return scored;
}

ScoredScan score(const Scan& scan, const AlignabilityOptions& options) { return Scorer(options).score(scan); }

std::string_view to_string(Engine engine) { return engine == Engine::native ? "native" : "pcl"; }

double value_of(Reading reading, const Readings& readings) {
  switch (reading) {
    case Reading::centred:
      return readings.centred;
    case Reading::voxel:
      return readings.voxel;
    case Reading::robust:
      return readings.robust;
    case Reading::information:
      break;
  }
  return readings.information.least;
}

std::string_view to_string(Reading reading) {
  switch (reading) {
    case Reading::centred:
      return "centred";
    case Reading::voxel:
      return "voxel";
    case Reading::robust:
      return "robust";
    case Reading::information:
      break;
  }
  return "information";
}

std::string to_yaml(const AlignabilityOptions& options) {
  std::ostringstream out;
  out << "engine: " << to_string(options.segmentation.engine) << '\n'
      << "engine_revision: " << kEngineRevision << '\n'
      << "min_range: " << to_text(options.segmentation.range_min) << '\n'
      << "normal_neighbours: " << options.segmentation.normal_neighbours << '\n'
      << "growing_neighbours: " << options.segmentation.growing_neighbours << '\n'
      << "smoothness_deg: " << to_text(degrees(options.segmentation.smoothness)) << '\n'
      << "curvature: " << to_text(options.segmentation.curvature) << '\n'
      << "min_points: " << options.segmentation.min_points << '\n'
      << "stride: " << options.segmentation.stride << '\n'
      << "plane_threshold: " << to_text(options.plane_threshold) << '\n'
      << "min_area: " << to_text(options.min_area) << '\n'
      << "centred: " << (options.moment == Moment::about_mean ? "true" : "false") << '\n';
  if (options.segmentation.dimensions == Dimensions::two) {
    out << "dimensions: 2\nmin_line_points: " << options.segmentation.min_line_points << "\nmin_length: " << to_text(options.min_length)
        << '\n';
  }
  if (!options.readings.empty()) {
    out << "readings: [";
    for (const Reading reading : options.readings) out << (reading == options.readings.front() ? "" : ", ") << to_string(reading);
    out << "]\nvoxel: " << to_text(options.voxel) << "\nrange_stddev: " << to_text(options.range_stddev) << '\n';
  }
  return out.str();
}

}  // namespace alignability
