// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/primitives.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace alignability {
namespace {

constexpr int kSidesPerTurn = 48;

// A point of a half-plane through the z axis.
struct ProfilePoint {
  double radius;
  double z;
};

// The solid swept by turning a profile about z. The profile runs upwards; its ends are closed by fans to the axis.
TriangleMesh solid_of_revolution(std::string name, const std::vector<ProfilePoint>& profile) {
  TriangleMesh mesh{.name = std::move(name), .vertices = {}, .triangles = {}};
  for (const ProfilePoint& point : profile) {
    for (int side = 0; side < kSidesPerTurn; ++side) {
      const double angle = 2.0 * std::numbers::pi * side / kSidesPerTurn;
      mesh.vertices.push_back(Eigen::Vector3d(point.radius * std::cos(angle), point.radius * std::sin(angle), point.z).cast<float>());
    }
  }
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::uint32_t top = bottom + 1;
  mesh.vertices.emplace_back(0.0f, 0.0f, static_cast<float>(profile.front().z));
  mesh.vertices.emplace_back(0.0f, 0.0f, static_cast<float>(profile.back().z));

  const std::uint32_t last_ring = bottom - kSidesPerTurn;
  for (std::uint32_t side = 0; side < kSidesPerTurn; ++side) {
    const std::uint32_t next = (side + 1) % kSidesPerTurn;
    mesh.triangles.push_back({bottom, next, side});
    mesh.triangles.push_back({top, last_ring + side, last_ring + next});
    for (std::uint32_t ring = 0; ring < last_ring; ring += kSidesPerTurn) {
      mesh.triangles.push_back({ring + side, ring + next, ring + kSidesPerTurn + next});
      mesh.triangles.push_back({ring + side, ring + kSidesPerTurn + next, ring + kSidesPerTurn + side});
    }
  }
  return mesh;
}

// A half circle from pole to pole, both left out; its halves are set apart by `gap`.
std::vector<ProfilePoint> half_circle(double radius, double gap) {
  constexpr int kSteps = kSidesPerTurn / 2;
  std::vector<ProfilePoint> profile;
  for (int step = 1; step < kSteps; ++step) {
    const double latitude = std::numbers::pi * (static_cast<double>(step) / kSteps - 0.5);
    const ProfilePoint point{radius * std::cos(latitude), radius * std::sin(latitude)};
    if (2 * step <= kSteps) profile.push_back({point.radius, point.z - gap / 2});
    if (2 * step > kSteps || (2 * step == kSteps && gap > 0.0)) profile.push_back({point.radius, point.z + gap / 2});
  }
  return profile;
}

TriangleMesh round_ended(std::string name, double radius, double gap) {
  TriangleMesh mesh = solid_of_revolution(std::move(name), half_circle(radius, gap));
  const auto pole = static_cast<float>(radius + gap / 2);
  mesh.vertices[mesh.vertices.size() - 2].z() = -pole;
  mesh.vertices.back().z() = pole;
  return mesh;
}

}  // namespace

TriangleMesh make_box(const Eigen::Vector3d& size) {
  TriangleMesh mesh{.name = "box", .vertices = {}, .triangles = {}};
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(sign.cwiseProduct(size).cast<float>());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh make_cylinder(double radius, double length) {
  return solid_of_revolution("cylinder", {{radius, -length / 2}, {radius, length / 2}});
}

TriangleMesh make_sphere(double radius) { return round_ended("sphere", radius, 0.0); }

TriangleMesh make_ellipsoid(const Eigen::Vector3d& radii) {
  TriangleMesh mesh = transformed(round_ended("ellipsoid", 1.0, 0.0), Eigen::Affine3d(Eigen::Scaling(radii)));
  return mesh;
}

TriangleMesh make_capsule(double radius, double length) { return round_ended("capsule", radius, length); }

TriangleMesh make_rectangle(double size_x, double size_y) {
  TriangleMesh mesh{.name = "rectangle", .vertices = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}};
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    mesh.vertices.push_back(Eigen::Vector3d(x * size_x, y * size_y, 0.0).cast<float>());
  }
  return mesh;
}

}  // namespace alignability
