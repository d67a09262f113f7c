// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/disc_cloud.hpp"

#include <pcl/features/normal_3d.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/range.hpp"
#include "lidar/in_parallel.hpp"
#include "lidar/thinning.hpp"

namespace alignability {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Tree = pcl::KdTreeFLANN<pcl::PointXYZ>;

void check(const DiscOptions& options) {
  if (options.neighbours < 4) throw std::invalid_argument("a normal is taken from at least 4 neighbours");
  if (options.spacing_neighbours < 1 || options.spacing_neighbours > options.neighbours) {
    throw std::invalid_argument("the spacing is taken from 1 neighbour to as many as the normal");
  }
  if (!kPositive.contains(options.overlap)) throw std::invalid_argument("the overlap of discs must be greater than 0");
  if (!(options.most_spacings >= 1.0)) throw std::invalid_argument("the largest radius must be at least the median one");
}

// The finite points, each once, with their normals.
PointCloud different(const PointCloud& cloud) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.points[i].allFinite()) order.push_back(i);
  }
  const auto place = [&](std::size_t i) {
    const Eigen::Vector3f& point = cloud.points[i];
    return std::tuple(point.x(), point.y(), point.z());
  };
  std::ranges::stable_sort(order, {}, place);
  order.erase(std::ranges::unique(order, {}, place).begin(), order.end());
  PointCloud kept;
  for (const std::size_t i : order) {
    kept.points.push_back(cloud.points[i]);
    if (!cloud.normals.empty()) kept.normals.push_back(cloud.normals[i]);
  }
  return kept;
}

PointCloud prepared(const PointCloud& cloud, const DiscOptions& options) {
  if (!options.thinning) return different(cloud);
  return {.points = thinned(cloud.points, *options.thinning), .normals = {}};
}

Points::Ptr to_pcl(const std::vector<Eigen::Vector3f>& points) {
  Points::Ptr result(new Points);
  for (const Eigen::Vector3f& point : points) result->push_back({point.x(), point.y(), point.z()});
  return result;
}

std::optional<Eigen::Vector3f> unit(const Eigen::Vector3f& normal) {
  const float length = normal.norm();
  if (!(length > 0.0f) || !std::isfinite(length)) return std::nullopt;
  return normal / length;
}

// What the neighbours of each point say of the surface there.
struct Neighbourhoods {
  std::size_t count;                 // of neighbours, the point itself among them
  std::vector<std::int32_t> points;  // `count` for each point, the nearest, itself, first
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> curvatures;  // λ_min over the trace: 0 in a plane
  std::vector<float> spacings;

  std::span<const std::int32_t> of(std::size_t point) const { return std::span(points).subspan(point * count, count); }
};

Neighbourhoods neighbourhoods_of(const std::vector<Eigen::Vector3f>& points, const DiscOptions& options) {
  const Points::Ptr cloud = to_pcl(points);
  Tree tree;
  tree.setInputCloud(cloud);
  const auto count = static_cast<std::size_t>(options.neighbours) + 1;
  Neighbourhoods around{.count = count,
                        .points = std::vector<std::int32_t>(points.size() * count),
                        .normals = std::vector<Eigen::Vector3f>(points.size()),
                        .curvatures = std::vector<float>(points.size()),
                        .spacings = std::vector<float>(points.size())};
  in_parallel(points.size(), 0, [&](std::size_t i) {
    pcl::Indices nearest;
    std::vector<float> distances2;
    tree.nearestKSearch((*cloud)[i], static_cast<int>(count), nearest, distances2);
    Eigen::Vector4f plane = Eigen::Vector4f::Zero();
    pcl::computePointNormal(*cloud, nearest, plane, around.curvatures[i]);
    std::ranges::copy(nearest, around.points.begin() + static_cast<std::ptrdiff_t>(i * count));
    around.normals[i] = unit(plane.head<3>()).value_or(Eigen::Vector3f::UnitZ());
    around.spacings[i] = std::sqrt(distances2[static_cast<std::size_t>(options.spacing_neighbours)]);
  });
  return around;
}

// Near an edge the neighbours lie on both sides of it and their axis on neither. Of those whose plane passes through the point, the
// flattest neighbourhood says better what the surface is.
Eigen::Vector3f normal_at(std::size_t point, const std::vector<Eigen::Vector3f>& points, const Neighbourhoods& around) {
  constexpr float kInPlane = 0.25f;  // of the spacing
  std::size_t flattest = point;
  for (const std::int32_t neighbour : around.of(point)) {
    const auto i = static_cast<std::size_t>(neighbour);
    const float off_plane = std::abs(around.normals[i].dot(points[point] - points[i]));
    if (off_plane <= kInPlane * around.spacings[point] && around.curvatures[i] < around.curvatures[flattest]) flattest = i;
  }
  return around.normals[flattest];
}

float median(std::vector<float> values) {
  if (values.empty()) return std::numeric_limits<float>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

DiscCloud discs_of(const PointCloud& cloud, const DiscOptions& options) {
  check(options);
  PointCloud kept = prepared(cloud, options);
  const std::size_t least = static_cast<std::size_t>(options.neighbours) + 1;
  if (kept.points.size() < least) {
    throw std::invalid_argument("of " + std::to_string(cloud.points.size()) + " points " + std::to_string(kept.points.size()) +
                                " are left that are finite and differ; surfaces take at least " + std::to_string(least));
  }
  const Neighbourhoods around = neighbourhoods_of(kept.points, options);
  DiscCloud discs;
  discs.normals.resize(kept.points.size());
  discs.radii.resize(kept.points.size());
  in_parallel(kept.points.size(), 0, [&](std::size_t i) {
    const auto given = kept.normals.empty() ? std::nullopt : unit(kept.normals[i]);
    discs.normals[i] = given ? *given : normal_at(i, kept.points, around);
    discs.radii[i] = static_cast<float>(options.overlap) * around.spacings[i];
  });
  discs.centers = std::move(kept.points);
  const float largest = static_cast<float>(options.most_spacings) * median_radius(discs);
  for (float& radius : discs.radii) radius = std::min(radius, largest);
  return discs;
}

Eigen::AlignedBox3f bounds(const DiscCloud& discs, std::size_t disc) {
  // How far a disc reaches along an axis: r · sin of the angle between axis and normal.
  const Eigen::Array3f reach = discs.radii[disc] * (1.0f - discs.normals[disc].array().square()).max(0.0f).sqrt();
  return {(discs.centers[disc].array() - reach).matrix(), (discs.centers[disc].array() + reach).matrix()};
}

Eigen::AlignedBox3f bounds(const DiscCloud& discs) {
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < discs.size(); ++i) box.extend(bounds(discs, i));
  return box;
}

float median_radius(const DiscCloud& discs) { return median(discs.radii); }

}  // namespace alignability
