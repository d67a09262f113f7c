// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace alignability {

/// Triangles in the `map` frame [m], their corners counter-clockwise seen from outside.
struct TriangleMesh {
  std::string name;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The mesh under `transform`. One that mirrors turns the corners' order round, so that outside stays outside.
TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Affine3d& transform);

TriangleMesh merged(std::span<const TriangleMesh> meshes, std::string name);

/// Empty when there are no vertices.
Eigen::AlignedBox3f bounds(const TriangleMesh& mesh);

/// The triangles that enclose a volume, on vertices that are no longer repeated (those equal to 1e-6 m are one). Triangles connected along
/// edges are closed where every edge is walked equally often in both directions; those with a rim, such as a lone sheet, are left out.
/// Triangles that touch one vertex twice are dropped.
TriangleMesh closed_part(const TriangleMesh& mesh);

}  // namespace alignability
