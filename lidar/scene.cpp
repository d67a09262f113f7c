// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "lidar/in_parallel.hpp"

namespace alignability {
namespace {

constexpr std::size_t kPacket = 16;

// Embree takes a component of a direction below it for +1e-18 where it divides by it, whatever its sign, and for negative where it sorts
// the rays of a packet by their signs: all rays of that packet then miss.
constexpr float kLeastComponent = 1e-18f;

Eigen::Vector3f without_traces(const Eigen::Vector3f& direction) {
  return (direction.array().abs() < kLeastComponent).select(0.0f, direction);
}

template <typename Handle, void (*release)(Handle)>
struct Release {
  void operator()(Handle handle) const { release(handle); }
};
template <typename Handle, void (*release)(Handle)>
using Unique = std::unique_ptr<std::remove_pointer_t<Handle>, Release<Handle, release>>;
using Device = Unique<RTCDevice, rtcReleaseDevice>;
using EmbreeScene = Unique<RTCScene, rtcReleaseScene>;
using Geometry = Unique<RTCGeometry, rtcReleaseGeometry>;

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw std::runtime_error("Embree failed with error " + std::to_string(error) +
                           (error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory" : ""));
}

void check_vertices(const TriangleMesh& mesh) {
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    if (!vertex.allFinite()) throw std::invalid_argument("mesh '" + mesh.name + "' has a vertex that is not finite");
  }
  for (const auto& triangle : mesh.triangles) {
    if (std::ranges::max(triangle) >= mesh.vertices.size()) {
      throw std::invalid_argument("mesh '" + mesh.name + "' has a triangle with a vertex that is not there");
    }
  }
}

void check_discs(const DiscCloud& discs) {
  if (discs.normals.size() != discs.size() || discs.radii.size() != discs.size()) {
    throw std::invalid_argument("a disc has a center, a normal and a radius");
  }
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (!discs.centers[i].allFinite() || !discs.normals[i].allFinite() || !(discs.radii[i] >= 0.0f) || !std::isfinite(discs.radii[i])) {
      throw std::invalid_argument("disc " + std::to_string(i) + ", counted from 0, is not finite");
    }
  }
}

// Copies the triangles, as Embree wants a padded buffer of its own.
void attach(RTCDevice device, RTCScene scene, const TriangleMesh& mesh) {
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  if (!mesh.triangles.empty()) {
    void* vertices =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                                              mesh.triangles.size());
    check(device);
    std::ranges::copy(mesh.vertices, static_cast<Eigen::Vector3f*>(vertices));
    std::ranges::copy(mesh.triangles, static_cast<std::array<std::uint32_t, 3>*>(triangles));
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene, geometry.get());
  check(device);
}

void attach(RTCDevice device, RTCScene scene, const DiscCloud& discs) {
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT));
  void* spheres = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), discs.size());
  void* normals = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), discs.size());
  check(device);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Eigen::Vector3f& center = discs.centers[i];
    static_cast<std::array<float, 4>*>(spheres)[i] = {center.x(), center.y(), center.z(), discs.radii[i]};
  }
  std::ranges::copy(discs.normals, static_cast<Eigen::Vector3f*>(normals));
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene, geometry.get());
  check(device);
}

// The boxes of discs: point queries pass over Embree's own point geometry.
EmbreeScene build_boxes(RTCDevice device, const DiscCloud& discs) {
  EmbreeScene scene(rtcNewScene(device));
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(discs.size()));
  rtcSetGeometryUserData(geometry.get(), const_cast<DiscCloud*>(&discs));
  const auto box_of = [](const RTCBoundsFunctionArguments* wanted) {
    const Eigen::AlignedBox3f box = bounds(*static_cast<const DiscCloud*>(wanted->geometryUserPtr), wanted->primID);
    RTCBounds& into = *wanted->bounds_o;
    into.lower_x = box.min().x();
    into.lower_y = box.min().y();
    into.lower_z = box.min().z();
    into.upper_x = box.max().x();
    into.upper_y = box.max().y();
    into.upper_z = box.max().z();
  };
  rtcSetGeometryBoundsFunction(geometry.get(), box_of, nullptr);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  check(device);
  rtcCommitScene(scene.get());
  check(device);
  return scene;
}

// The geometry with the number i is meshes[i]; the discs, where there are any, come last.
EmbreeScene build(RTCDevice device, const std::vector<TriangleMesh>& meshes, const DiscCloud& discs) {
  EmbreeScene scene(rtcNewScene(device));
  check(device);
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  for (const TriangleMesh& mesh : meshes) attach(device, scene.get(), mesh);
  if (!discs.empty()) attach(device, scene.get(), discs);
  // Embree builds with denormals flushed to zero. Were its commit this thread's first use of TBB, all tasks that the thread
  // starts later would run so too.
  in_parallel(1, 0, [](std::size_t) {});
  rtcCommitScene(scene.get());
  check(device);
  return scene;
}

// The closed parts of the meshes; what looks for vertical crossings needs them only, and flat: with all z = 0.
std::vector<TriangleMesh> closed_parts(const std::vector<TriangleMesh>& meshes) {
  std::vector<TriangleMesh> parts;
  for (const TriangleMesh& mesh : meshes) parts.push_back(closed_part(mesh));
  return parts;
}

std::vector<TriangleMesh> flattened(std::vector<TriangleMesh> meshes) {
  for (TriangleMesh& mesh : meshes) {
    for (Eigen::Vector3f& vertex : mesh.vertices) vertex.z() = 0.0f;
  }
  return meshes;
}

// Whether p lies left of the line a→b as seen from above. Points on the line count as if p stood a trifle towards +y and a smaller
// trifle towards -x, so that of the triangles that share an edge exactly one claims p.
bool is_left_of(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& p) {
  const bool ascending = std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  const Eigen::Vector2d from = (ascending ? a : b).head<2>().cast<double>();
  const Eigen::Vector2d to = (ascending ? b : a).head<2>().cast<double>();
  const Eigen::Vector2d along = to - from;
  const Eigen::Vector2d offset = p.head<2>().cast<double>() - from;
  return (along.x() * offset.y() - along.y() * offset.x() >= 0.0) == ascending;
}

using Corners = std::array<Eigen::Vector3f, 3>;

Corners corners_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

// Height of the triangle's plane over the point's (x, y); the triangle is not vertical.
double height_at(const Corners& triangle, const Eigen::Vector3f& point) {
  const Eigen::Vector3d a = triangle[0].cast<double>();
  const Eigen::Vector3d normal = (triangle[1].cast<double>() - a).cross(triangle[2].cast<double>() - a);
  const Eigen::Vector2d offset = point.head<2>().cast<double>() - a.head<2>();
  const double height = a.z() - normal.head<2>().dot(offset) / normal.z();
  const auto [low, high] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
  return std::isfinite(height) ? std::clamp(height, static_cast<double>(low), static_cast<double>(high)) : high;
}

// What the ray from the point upwards does at the triangle: 1 leaves through it, -1 enters, 0 misses it.
int vertical_crossing(const Corners& triangle, const Eigen::Vector3f& point) {
  const bool left_of_first = is_left_of(triangle[0], triangle[1], point);
  if (is_left_of(triangle[1], triangle[2], point) != left_of_first) return 0;
  if (is_left_of(triangle[2], triangle[0], point) != left_of_first) return 0;
  if (height_at(triangle, point) < point.z()) return 0;
  return left_of_first ? 1 : -1;
}

// Ericson, Real-Time Collision Detection, 5.1.5.
Eigen::Vector3f closest_point(const Corners& triangle, const Eigen::Vector3f& point) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3f ab = b - a, ac = c - a, ap = point - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return a;
  const Eigen::Vector3f bp = point - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0f && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return a + d1 / (d1 - d3) * ab;
  const Eigen::Vector3f cp = point - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0f && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

float distance(const Eigen::Vector3f& center, const Eigen::Vector3f& normal, float radius, const Eigen::Vector3f& point) {
  const Eigen::Vector3f offset = point - center;
  const float across = normal.dot(offset);
  const float beyond_rim = std::max(0.0f, (offset - across * normal).norm() - radius);
  return std::hypot(across, beyond_rim);
}

// Calls visit(geometry, primitive) for at least every one nearer to the point than `radius`.
template <typename Visit>
void visit_near(RTCScene scene, const Eigen::Vector3f& point, float radius, Visit visit) {
  RTCPointQuery query{.x = point.x(), .y = point.y(), .z = point.z(), .time = 0.0f, .radius = radius};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const auto call = [](RTCPointQueryFunctionArguments* found) {
    (*static_cast<Visit*>(found->userPtr))(found->geomID, found->primID);
    return false;
  };
  rtcPointQuery(scene, &query, &context, call, &visit);
}

}  // namespace

struct Scene::Data {
  std::vector<TriangleMesh> meshes;
  DiscCloud discs;
  std::vector<TriangleMesh> solids;
  Eigen::AlignedBox3f bounds;
  Device device;
  EmbreeScene surfaces;
  EmbreeScene footprints;  // of the solids, in the plane z = 0
  EmbreeScene disc_boxes;
};

Scene::Scene(std::vector<TriangleMesh> meshes, DiscCloud discs) {
  auto data = std::make_shared<Data>();
  data->meshes = std::move(meshes);
  data->discs = std::move(discs);
  check_discs(data->discs);
  for (const TriangleMesh& mesh : data->meshes) {
    check_vertices(mesh);
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t vertex : triangle) data->bounds.extend(mesh.vertices[vertex]);
    }
  }
  data->bounds.extend(alignability::bounds(data->discs));
  data->solids = closed_parts(data->meshes);
  data->device.reset(rtcNewDevice(nullptr));
  check(data->device.get());
  data->surfaces = build(data->device.get(), data->meshes, data->discs);
  data->footprints = build(data->device.get(), flattened(data->solids), {});
  data->disc_boxes = build_boxes(data->device.get(), data->discs);
  data_ = std::move(data);
}

const std::vector<TriangleMesh>& Scene::meshes() const { return data_->meshes; }

const DiscCloud& Scene::discs() const { return data_->discs; }

Eigen::AlignedBox3f Scene::bounds() const { return data_->bounds; }

std::vector<float> Scene::cast(const Eigen::Vector3f& origin, std::span<const Eigen::Vector3f> directions, float max_range) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  std::vector<float> ranges(directions.size());
  for (std::size_t first = 0; first < directions.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, directions.size() - first);
    alignas(64) std::array<int, kPacket> valid{};
    RTCRayHit16 packet;
    for (std::size_t i = 0; i < kPacket; ++i) {
      // Embree wants good numbers in the lanes that are not used, too.
      const Eigen::Vector3f direction = without_traces(directions[first + std::min(i, count - 1)]);
      valid[i] = i < count ? -1 : 0;
      packet.ray.org_x[i] = origin.x();
      packet.ray.org_y[i] = origin.y();
      packet.ray.org_z[i] = origin.z();
      packet.ray.dir_x[i] = direction.x();
      packet.ray.dir_y[i] = direction.y();
      packet.ray.dir_z[i] = direction.z();
      packet.ray.tnear[i] = 0.0f;
      packet.ray.tfar[i] = max_range;
      packet.ray.time[i] = 0.0f;
      packet.ray.mask[i] = ~0u;
      packet.ray.flags[i] = 0;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), data_->surfaces.get(), &context, &packet);
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      ranges[first + i] = hit ? packet.ray.tfar[i] : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return ranges;
}

bool Scene::is_free(const Eigen::Vector3f& point, float clearance) const {
  bool touched = false;
  visit_near(data_->surfaces.get(), point, clearance, [&](unsigned geometry, unsigned primitive) {
    if (geometry >= data_->meshes.size()) return;
    touched = touched || (closest_point(corners_of(data_->meshes[geometry], primitive), point) - point).norm() < clearance;
  });
  const DiscCloud& discs = data_->discs;
  visit_near(data_->disc_boxes.get(), point, clearance, [&](unsigned, unsigned i) {
    touched = touched || distance(discs.centers[i], discs.normals[i], discs.radii[i], point) < clearance;
  });
  if (touched) return false;

  int crossings = 0;
  const Eigen::Vector3f foot(point.x(), point.y(), 0.0f);
  // What is within any distance of the foot includes all that lies above and below it.
  visit_near(data_->footprints.get(), foot, 0.0f, [&](unsigned geometry, unsigned primitive) {
    crossings += vertical_crossing(corners_of(data_->solids[geometry], primitive), point);
  });
  return crossings <= 0;
}

}  // namespace alignability
