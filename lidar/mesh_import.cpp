// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/mesh_import.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <exception>
#include <span>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

constexpr unsigned kAllButPositions = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                      aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES |
                                      aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

bool all_finite(const aiMesh& mesh) {
  return std::all_of(mesh.mVertices, mesh.mVertices + mesh.mNumVertices, [](const aiVector3D& vertex) {
    return std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z);
  });
}

// What the importer's later steps take for granted, and what they would hide: they join vertices that are not numbers to others.
void check_mesh(const aiMesh& mesh, const std::filesystem::path& file) {
  if (!all_finite(mesh)) throw InputError(file, "has a vertex that is not finite");
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices == 0) throw InputError(file, "has a face without corners");
    const unsigned last = *std::max_element(face.mIndices, face.mIndices + face.mNumIndices);
    if (last < mesh.mNumVertices) continue;
    throw InputError(
        file, "has a face with vertex " + std::to_string(last) + ", counted from 0, of " + std::to_string(mesh.mNumVertices) + " vertices");
  }
}

bool has_area(const aiMesh* mesh) {
  return std::any_of(mesh->mFaces, mesh->mFaces + mesh->mNumFaces, [](const aiFace& face) { return face.mNumIndices >= 3; });
}

const aiScene& require(const aiScene* scene, const Assimp::Importer& importer, const std::filesystem::path& file) {
  if (scene == nullptr) throw InputError(file, std::string("cannot be read as a mesh: ") + importer.GetErrorString());
  return *scene;
}

const aiScene& import(Assimp::Importer& importer, const std::filesystem::path& file, const MeshOptions& options) {
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, static_cast<int>(kAllButPositions));
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, options.up_axis.has_value());
  try {
    const aiScene& raw = require(importer.ReadFile(file.string(), 0), importer, file);
    const std::span meshes(raw.mMeshes, raw.mNumMeshes);
    for (const aiMesh* mesh : meshes) check_mesh(*mesh, file);
    if (std::ranges::none_of(meshes, has_area)) throw InputError(file, "holds no triangles");
    constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices;
    return require(importer.ApplyPostProcessing(kSteps), importer, file);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(file, std::string("cannot be read as a mesh: ") + error.what());
  }
}

Eigen::Affine3d to_eigen(const aiMatrix4x4& matrix) {
  Eigen::Affine3d result;
  result.matrix() << matrix.a1, matrix.a2, matrix.a3, matrix.a4, matrix.b1, matrix.b2, matrix.b3, matrix.b4, matrix.c1, matrix.c2,
      matrix.c3, matrix.c4, matrix.d1, matrix.d2, matrix.d3, matrix.d4;
  return result;
}

// From the importer's root frame to ours. Of COLLADA it has turned y up, unless told not to, and has put the file's unit into the root
// node.
Eigen::Affine3d root_correction(const aiScene& scene, const std::string& extension, const MeshOptions& options) {
  const bool y_is_up = extension == ".dae" || extension == ".gltf" || extension == ".glb";
  const UpAxis up = options.up_axis.value_or(y_is_up ? UpAxis::y : UpAxis::z);
  double scale = options.unit.value_or(1.0);
  if (options.unit && extension == ".dae") scale /= std::cbrt(to_eigen(scene.mRootNode->mTransformation).linear().determinant());
  return Eigen::Affine3d(scale * to_z_up(up));
}

// Gathers the triangles of a tree of nodes.
class Collector {
 public:
  Collector(const aiScene& scene, std::filesystem::path file, std::optional<std::string> submesh)
      : scene_(scene), file_(std::move(file)), submesh_(std::move(submesh)) {}

  void visit(const aiNode& node, const Eigen::Affine3d& T_map_parent) {
    const Eigen::Affine3d T_map_node = T_map_parent * to_eigen(node.mTransformation);
    std::vector<TriangleMesh> parts;  // one a material
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
      if (!submesh_ || *submesh_ == node.mName.C_Str() || *submesh_ == mesh.mName.C_Str()) parts.push_back(convert(mesh));
    }
    add(merged(parts, node.mName.C_Str()), T_map_node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], T_map_node);
  }

  std::vector<TriangleMesh> result() && { return std::move(meshes_); }

 private:
  TriangleMesh convert(const aiMesh& mesh) {
    triangles_ += mesh.mNumFaces;
    if (triangles_ > kMostTriangles) throw InputError(file_, "has more than " + std::to_string(kMostTriangles) + " triangles");
    TriangleMesh part;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
      part.vertices.emplace_back(mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices == 3) part.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    return part;
  }

  void add(const TriangleMesh& mesh, const Eigen::Affine3d& T_map_node) {
    if (mesh.triangles.empty()) return;
    meshes_.push_back(transformed(mesh, T_map_node));
    const auto finite = [](const Eigen::Vector3f& vertex) { return vertex.allFinite(); };
    if (!std::ranges::all_of(meshes_.back().vertices, finite)) throw InputError(file_, "has a vertex that is not finite");
  }

  const aiScene& scene_;
  std::filesystem::path file_;
  std::optional<std::string> submesh_;
  std::vector<TriangleMesh> meshes_;
  std::size_t triangles_ = 0;
};

}  // namespace

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

std::vector<TriangleMesh> import_meshes(const std::filesystem::path& file, const MeshOptions& options) {
  Assimp::Importer importer;
  const aiScene& scene = import(importer, file, options);
  Collector collector(scene, file, options.submesh);
  collector.visit(*scene.mRootNode, root_correction(scene, lower_extension(file), options));
  return std::move(collector).result();
}

}  // namespace alignability::detail
