// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sample_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <stdexcept>

#include "core/range.hpp"

namespace alignability {
namespace {

constexpr double kMostPoints = 1 << 26;

struct Facet {
  Eigen::Vector3d corner, side, other_side;
  Eigen::Vector3d doubled_area;  // along the normal
};

Facet facet_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3d corner = mesh.vertices[a].cast<double>();
  const Eigen::Vector3d side = mesh.vertices[b].cast<double>() - corner;
  const Eigen::Vector3d other_side = mesh.vertices[c].cast<double>() - corner;
  return {corner, side, other_side, side.cross(other_side)};
}

// Draws as std::… would, but the same numbers with every standard library.
class Sampler {
 public:
  explicit Sampler(const SampleOptions& options) : options_(options), engine_(options.seed) {}

  void add(const Facet& facet) {
    const double area = 0.5 * facet.doubled_area.norm();
    if (!(area > 0.0)) return;
    const Eigen::Vector3d normal = facet.doubled_area.normalized();
    const double wanted = area / (options_.spacing * options_.spacing) + uniform_(engine_);
    for (double i = 1.0; i <= wanted; ++i) {
      const Eigen::Vector3d point = place_in(facet) + options_.stddev * noise_(engine_) * normal;
      cloud_.points.push_back(point.cast<float>());
      cloud_.normals.push_back(normal.cast<float>());
    }
  }

  PointCloud result() && { return std::move(cloud_); }

 private:
  Eigen::Vector3d place_in(const Facet& facet) {
    double u = uniform_(engine_), v = uniform_(engine_);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    return facet.corner + u * facet.side + v * facet.other_side;
  }

  SampleOptions options_;
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
  boost::random::normal_distribution<double> noise_;
  PointCloud cloud_;
};

}  // namespace

PointCloud sample_surface(const std::vector<TriangleMesh>& meshes, const SampleOptions& options) {
  if (!kPositive.contains(options.spacing)) throw std::invalid_argument("the spacing of points must be greater than 0");
  if (!(options.stddev >= 0.0) || !std::isfinite(options.stddev)) throw std::invalid_argument("points scatter by 0 or more");
  double area = 0.0;
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += 0.5 * facet_of(mesh, i).doubled_area.norm();
  }
  if (area / (options.spacing * options.spacing) > kMostPoints) throw std::invalid_argument("the spacing asks for more than 2^26 points");
  Sampler sampler(options);
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sampler.add(facet_of(mesh, i));
  }
  return std::move(sampler).result();
}

}  // namespace alignability
