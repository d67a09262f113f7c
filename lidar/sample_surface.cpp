// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sample_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/range.hpp"
#include "lidar/in_parallel.hpp"
#include "lidar/scene.hpp"

namespace alignability {
namespace {

using Engine = boost::random::mt19937_64;

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

// How far to either side of a surface to look for free space [m]: farther than single precision errs in a site of kilometres.
constexpr float kBeside = 1e-3f;

// Draws as std::… would, but the same numbers with every standard library.
class Sampler {
 public:
  Sampler(double spacing, Engine& engine) : spacing_(spacing), engine_(engine) {}

  void add(const Facet& facet) {
    const double area = 0.5 * facet.doubled_area.norm();
    if (!(area > 0.0)) return;
    const Eigen::Vector3d normal = facet.doubled_area.normalized();
    const double wanted = area / (spacing_ * spacing_) + uniform_(engine_);
    for (double i = 1.0; i <= wanted; ++i) {
      cloud_.points.push_back(place_in(facet).cast<float>());
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

  double spacing_;
  Engine& engine_;
  boost::random::uniform_01<double> uniform_;
  PointCloud cloud_;
};

// Whether a scanner may look at the surface from the place just beside it: not from within something solid, and not from under the
// lowest floor.
bool is_seen_from(const Scene& scene, const Eigen::Vector3f& place, const Eigen::Vector3f& surface) {
  if (!scene.is_free(place, 0.0f)) return false;
  const Eigen::Vector3f up = surface - place;
  if (up.z() < 0.5f * up.norm()) return true;
  const Eigen::Vector3f down = -Eigen::Vector3f::UnitZ();
  return !std::isnan(scene.cast(place, {&down, 1}, std::numeric_limits<float>::infinity()).front());
}

// What no side shows is left out, and the rest scattered.
PointCloud seen(const PointCloud& cloud, const Scene& scene, double stddev, Engine& engine) {
  std::vector<char> is_seen(cloud.points.size());
  in_parallel(cloud.points.size(), 0, [&](std::size_t i) {
    const Eigen::Vector3f beside = kBeside * cloud.normals[i];
    is_seen[i] =
        is_seen_from(scene, cloud.points[i] + beside, cloud.points[i]) || is_seen_from(scene, cloud.points[i] - beside, cloud.points[i]);
  });
  boost::random::normal_distribution<double> noise;
  PointCloud kept;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!is_seen[i]) continue;
    kept.points.push_back(cloud.points[i] + static_cast<float>(stddev * noise(engine)) * cloud.normals[i]);
    kept.normals.push_back(cloud.normals[i]);
  }
  return kept;
}

}  // namespace

PointCloud sample_surface(const std::vector<TriangleMesh>& meshes, const SampleOptions& options) {
  if (!kPositive.contains(options.spacing)) throw std::invalid_argument("the spacing of points must be greater than 0");
  if (!(options.stddev >= 0.0) || !std::isfinite(options.stddev)) throw std::invalid_argument("points scatter by 0 or more");
  double area = 0.0;
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += 0.5 * facet_of(mesh, i).doubled_area.norm();
  }
  if (area / (options.spacing * options.spacing) > kMostPoints) throw std::invalid_argument("the spacing asks for more than 2^26 points");
  Engine engine(options.seed);
  Sampler sampler(options.spacing, engine);
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sampler.add(facet_of(mesh, i));
  }
  return seen(std::move(sampler).result(), Scene(meshes), options.stddev, engine);
}

}  // namespace alignability
