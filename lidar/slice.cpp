// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/slice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace alignability {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
using Polygon3 = std::vector<Eigen::Vector3d>;

// cos 60°: what is steeper is no floor.
constexpr double kLeastFloorNormal = 0.5;
// How far surfaces are drawn back into what they bound [m]: a face on the line between two map cells belongs to the cell behind it.
constexpr double kDrawnBack = 1e-4;
// Polygons thinner than this [m] in the plane are segments: far below a map cell, above the rounding of float coordinates.
constexpr double kThinnest = 1e-6;

Corners corners_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  Corners corners;
  for (int i = 0; i < 3; ++i) corners[i] = mesh.vertices[triangle[i]].cast<double>();
  return corners;
}

// Where the edge between a point at or below the height and one above it passes the height. Takes them in this order, so that both
// triangles of an edge find the same point to the bit.
Eigen::Vector3d crossing(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double height) {
  Eigen::Vector3d point = low + (height - low.z()) / (high.z() - low.z()) * (high - low);
  point.z() = height;
  return point;
}

// The part of a convex polygon with side * z ≤ side * height (Sutherland and Hodgman).
Polygon3 clipped(const Polygon3& polygon, double height, double side) {
  Polygon3 kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& here = polygon[i];
    const Eigen::Vector3d& next = polygon[(i + 1) % polygon.size()];
    const bool here_inside = side * here.z() <= side * height;
    const bool next_inside = side * next.z() <= side * height;
    if (here_inside) kept.push_back(here);
    if (here_inside != next_inside) kept.push_back(here.z() < next.z() ? crossing(here, next, height) : crossing(next, here, height));
  }
  return kept;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double doubled_area(const ConvexPolygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return sum;
}

// The longest distance between two corners, as a segment; a point when it has no length.
ConvexPolygon longest_chord(const ConvexPolygon& polygon) {
  ConvexPolygon chord{polygon.front()};
  double longest = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = i + 1; j < polygon.size(); ++j) {
      const double length = (polygon[j] - polygon[i]).norm();
      if (length <= longest) continue;
      longest = length;
      chord = {polygon[i], polygon[j]};
    }
  }
  return chord;
}

// Seen from above: counter-clockwise, or a segment or point where nothing is to be seen of its area.
ConvexPolygon projected(const Polygon3& polygon) {
  ConvexPolygon flat;
  for (const Eigen::Vector3d& point : polygon) {
    if (flat.empty() || flat.back() != point.head<2>()) flat.emplace_back(point.head<2>());
  }
  if (flat.size() > 1 && flat.front() == flat.back()) flat.pop_back();
  ConvexPolygon chord = longest_chord(flat);
  const double area = doubled_area(flat);
  if (chord.size() < 2 || std::abs(area) <= kThinnest * (chord[1] - chord[0]).norm()) return chord;
  if (area < 0.0) std::ranges::reverse(flat);
  return flat;
}

bool is_floor_like(const Corners& corners) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return std::abs(normal.z()) > kLeastFloorNormal * normal.norm();
}

// The triangle, moved sideways to its inside.
Polygon3 drawn_back(const Corners& corners) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const Eigen::Vector3d step(kDrawnBack * normal.x(), kDrawnBack * normal.y(), 0.0);
  return {corners[0] - step, corners[1] - step, corners[2] - step};
}

void add_surface(Slice& slice, const Corners& corners, double z_min, double z_max) {
  const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
  const Polygon3 triangle(corners.begin(), corners.end());
  if (high >= z_min && low <= z_max) slice.surfaces.push_back(projected(clipped(clipped(drawn_back(corners), z_max, 1.0), z_min, -1.0)));
  if (low > z_min || !is_floor_like(corners)) return;
  ConvexPolygon floor = projected(clipped(triangle, z_min, 1.0));
  if (floor.size() > 2) slice.floors.push_back(std::move(floor));
}

// A corner on the height itself counts as below it, so each of a surface's triangles is cut in two edges or in none. Seen with the
// outside in front, the way down from above the height stands left of the way up.
void add_cut(Slice& slice, const Corners& corners, double height) {
  DirectedEdge edge;
  int crossings = 0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& here = corners[i];
    const Eigen::Vector3d& next = corners[(i + 1) % 3];
    if (here.z() > height && next.z() <= height) edge.from = crossing(next, here, height).head<2>();
    if (here.z() <= height && next.z() > height) edge.to = crossing(here, next, height).head<2>();
    crossings += (here.z() > height) != (next.z() > height);
  }
  if (crossings == 2 && edge.from != edge.to) slice.solid_edges.push_back(edge);
}

void check(double z_min, double z_max) {
  if (!std::isfinite(z_min) || !std::isfinite(z_max) || z_min >= z_max) {
    throw std::invalid_argument("a slice needs finite heights, the lower one first");
  }
}

// Inscribed in the disc.
Polygon3 polygon_of(const DiscCloud& discs, std::size_t i) {
  constexpr int kCorners = 8;
  const Eigen::Vector3d normal = discs.normals[i].cast<double>();
  const Eigen::Vector3d across = discs.radii[i] * normal.unitOrthogonal();
  Polygon3 corners;
  for (int k = 0; k < kCorners; ++k) {
    corners.push_back(discs.centers[i].cast<double>() + Eigen::AngleAxisd(2.0 * std::numbers::pi * k / kCorners, normal) * across);
  }
  return corners;
}

}  // namespace

Slice slice(const std::vector<TriangleMesh>& meshes, double z_min, double z_max) {
  check(z_min, z_max);
  Slice result;
  for (const TriangleMesh& mesh : meshes) {
    for (const auto& triangle : mesh.triangles) add_surface(result, corners_of(mesh, triangle), z_min, z_max);
    const TriangleMesh solid = closed_part(mesh);
    for (const auto& triangle : solid.triangles) add_cut(result, corners_of(solid, triangle), (z_min + z_max) / 2.0);
  }
  return result;
}

Slice slice(const DiscCloud& discs, double z_min, double z_max) {
  check(z_min, z_max);
  Slice result;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Eigen::Vector3d center = discs.centers[i].cast<double>();
    if (center.z() >= z_min && center.z() <= z_max) result.surfaces.push_back({center.head<2>()});
    if (center.z() > z_min || std::abs(discs.normals[i].z()) <= kLeastFloorNormal) continue;
    ConvexPolygon floor = projected(clipped(polygon_of(discs, i), z_min, 1.0));
    if (floor.size() > 2) result.floors.push_back(std::move(floor));
  }
  return result;
}

}  // namespace alignability
