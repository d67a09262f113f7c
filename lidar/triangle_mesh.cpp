// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/triangle_mesh.hpp"

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace alignability {
namespace {

// Coordinates written with six decimals fall in the middle of a cell of this size, never on its border.
constexpr double kWeldCellsPerMetre = 1e6;

using VertexCell = std::array<std::int64_t, 3>;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

VertexCell cell_of(const Eigen::Vector3f& vertex) {
  VertexCell cell;
  for (int axis = 0; axis < 3; ++axis) cell[axis] = std::llround(static_cast<double>(vertex[axis]) * kWeldCellsPerMetre);
  return cell;
}

TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh result{.name = mesh.name, .vertices = {}, .triangles = {}};
  std::unordered_map<VertexCell, std::uint32_t, boost::hash<VertexCell>> index_of_cell;
  std::vector<std::uint32_t> new_index(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto [entry, fresh] = index_of_cell.try_emplace(cell_of(mesh.vertices[i]), static_cast<std::uint32_t>(result.vertices.size()));
    if (fresh) result.vertices.push_back(mesh.vertices[i]);
    new_index[i] = entry->second;
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{new_index[a], new_index[b], new_index[c]};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    result.triangles.push_back(triangle);
  }
  return result;
}

// How triangles hang together along an edge.
struct EdgeUse {
  std::size_t first_triangle = 0;
  // Walks in one direction less those in the other: not 0 at the rims of sheets and holes.
  int balance = 0;
};

// For every triangle whether those connected to it along edges have no rim.
std::vector<char> closed_triangles(const std::vector<Triangle>& triangles) {
  boost::disjoint_sets_with_storage<> components(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) components.make_set(i);
  std::unordered_map<Edge, EdgeUse, boost::hash<Edge>> edges;
  edges.reserve(2 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = triangles[i][corner];
      const std::uint32_t to = triangles[i][(corner + 1) % 3];
      const auto [entry, fresh] = edges.try_emplace(std::minmax(from, to), EdgeUse{.first_triangle = i});
      entry->second.balance += from < to ? 1 : -1;
      if (!fresh) components.union_set(entry->second.first_triangle, i);
    }
  }
  std::vector<char> has_rim(triangles.size(), 0);
  for (const auto& [edge, use] : edges) {
    if (use.balance != 0) has_rim[components.find_set(use.first_triangle)] = 1;
  }
  std::vector<char> closed(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) closed[i] = has_rim[components.find_set(i)] == 0;
  return closed;
}

}  // namespace

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Affine3d& transform) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3f& vertex : result.vertices) vertex = (transform * vertex.cast<double>()).cast<float>();
  if (transform.linear().determinant() < 0.0) {
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

Eigen::AlignedBox3f bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

TriangleMesh merged(std::span<const TriangleMesh> meshes, std::string name) {
  TriangleMesh result{.name = std::move(name), .vertices = {}, .triangles = {}};
  for (const TriangleMesh& mesh : meshes) {
    const auto offset = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) result.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return result;
}

TriangleMesh closed_part(const TriangleMesh& mesh) {
  TriangleMesh result = welded(mesh);
  const std::vector<char> closed = closed_triangles(result.triangles);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < result.triangles.size(); ++i) {
    if (closed[i] != 0) result.triangles[kept++] = result.triangles[i];
  }
  result.triangles.resize(kept);
  return result;
}

}  // namespace alignability
