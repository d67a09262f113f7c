// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/alignability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "alignability/segment_shape.hpp"
#include "alignability/segmentation_engines.hpp"
#include "core/range.hpp"

namespace alignability {
namespace {

// Σ n and Σ nnᵀ of the normals that vote.
struct NormalSums {
  double count = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& normal) {
    count += 1.0;
    first += normal;
    second += normal * normal.transpose();
  }
};

void set_moment(ScoredScan& scored, const NormalSums& sums, Moment moment) {
  if (sums.count == 0.0) return;
  Eigen::Matrix3d matrix = sums.second / sums.count;
  if (moment == Moment::about_mean) matrix -= sums.first * sums.first.transpose() / (sums.count * sums.count);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Alignability& result = scored.alignability;
  scored.axes = solver.eigenvectors().rowwise().reverse();
  result.eigenvalues = solver.eigenvalues().reverse().cwiseMax(0.0);
  result.weakest_direction = solver.eigenvectors().col(0);
  if (result.eigenvalues[0] > 0.0) result.alpha = std::clamp(result.eigenvalues[2] / result.eigenvalues[0], 0.0, 1.0);
}

}  // namespace

class Scorer::Implementation {
 public:
  explicit Implementation(const AlignabilityOptions& options) : options_(options) {
    if (options.segmentation.stride < 1 || options.segmentation.stride > kMostStride)
      throw std::invalid_argument("the stride must be 1 to 4");
    if (options.segmentation.stride > 1 && options.segmentation.engine == Engine::pcl) {
      throw std::invalid_argument("the engine pcl knows no stride");
    }
  }

  const Segmentation& segment(const Scan& scan) {
    if (options_.segmentation.engine == Engine::native) return native_.segment(scan, options_.segmentation);
    by_pcl_ = detail::segment_with_pcl(scan, options_.segmentation);
    return by_pcl_;
  }

  // `on_plane` is called with the members of each plane that is kept.
  template <typename OnPlane>
  ScoredScan score(const Scan& scan, const Segmentation& segmentation, OnPlane on_plane) {
    ScoredScan scored;
    Alignability& result = scored.alignability;
    result.points = segmentation.points;
    NormalSums sums;
    for (std::size_t segment = 0; segment < segmentation.segments(); ++segment) {
      const auto members = segmentation.segment(segment);
      const detail::SegmentShape shape = detail::shape_of(scan, members);
      if (!(shape.flatness() < options_.plane_threshold)) continue;
      ++result.planes_found;
      if (!(shape.area() > options_.min_area)) continue;
      for (const std::int32_t i : members) {
        const Eigen::Vector3f& normal = segmentation.normals[static_cast<std::size_t>(i)];
        if (normal.allFinite()) sums.add(normal.cast<double>());
      }
      on_plane(members, result.planes_kept++);
    }
    set_moment(scored, sums, options_.moment);
    return scored;
  }

 private:
  AlignabilityOptions options_;
  detail::NativeSegmenter native_;
  Segmentation by_pcl_;
};

Scorer::Scorer(const AlignabilityOptions& options) : implementation_(std::make_unique<Implementation>(options)) {}
Scorer::Scorer(Scorer&&) noexcept = default;
Scorer& Scorer::operator=(Scorer&&) noexcept = default;
Scorer::~Scorer() = default;

Alignability Scorer::alignability(const Scan& scan) {
  const auto pass = [](std::span<const std::int32_t>, int) {};
  return implementation_->score(scan, implementation_->segment(scan), pass).alignability;
}

ScoredScan Scorer::score(const Scan& scan) {
  const Segmentation& segmentation = implementation_->segment(scan);
  std::vector<int> plane_of_point(scan.points.size(), -1);
  const auto mark = [&](std::span<const std::int32_t> members, int plane) {
    for (const std::int32_t i : members) plane_of_point[static_cast<std::size_t>(i)] = plane;
  };
  ScoredScan scored = implementation_->score(scan, segmentation, mark);
  scored.plane_of_point = std::move(plane_of_point);
  scored.normals = segmentation.normals;
  return scored;
}

ScoredScan score(const Scan& scan, const AlignabilityOptions& options) { return Scorer(options).score(scan); }

std::string_view to_string(Engine engine) { return engine == Engine::native ? "native" : "pcl"; }

std::string to_yaml(const AlignabilityOptions& options) {
  std::ostringstream out;
  out << "engine: " << to_string(options.segmentation.engine) << '\n'
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
  return out.str();
}

}  // namespace alignability
