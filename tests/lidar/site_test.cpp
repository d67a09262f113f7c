// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/site.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lidar/sample_surface.hpp"
#include "lidar/scan_file.hpp"
#include "tests/lidar/fixtures.hpp"
#include "tests/lidar/sdf_text.hpp"
#include "tests/shared_data.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::kBox;
using test::kTetrahedron;
using test::model;
using test::shape;
using test::TemporaryFolder;
using test::world;
using test::write;

constexpr const char* kPlyPoints =
    "0 0 0\n1 0 0\n2 0 0\n3 0 0\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n0 3 0\n1 3 0\n2 3 0\n3 3 0\n";

std::string ply(const std::string& elements) {
  return "ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z\n" + elements + "end_header\n" +
         kPlyPoints;
}

const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

TEST(Site, IsAWorldAMeshOrACloud) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_site(write(folder, "w.sdf", world(model(shape(kBox))))).meshes.size(), 1u);
  EXPECT_EQ(read_site(write(folder, "t.obj", kTetrahedron)).meshes.size(), 1u);
  EXPECT_EQ(read_site(write(folder, "t.ply", ply(kFaces) + "3 0 1 4\n")).meshes.size(), 1u);
  const Site cloud = read_site(write(folder, "c.ply", ply("")));
  EXPECT_TRUE(cloud.meshes.empty());
  EXPECT_EQ(cloud.discs.size(), 16u);
}

TEST(Site, IsToldByItsContentWhateverItsName) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_site(write(folder, "world.txt", world(model(shape(kBox))))).meshes.size(), 1u);
  EXPECT_EQ(read_site(write(folder, "cloud.txt", ply(""))).discs.size(), 16u);
  EXPECT_EQ(read_site(write(folder, "no_faces.ply", ply("element face 0\nproperty list uchar int vertex_indices\n"))).discs.size(), 16u);
  write_pcd(read_scan_file(folder / "cloud.txt"), folder / "cloud.obj");
  EXPECT_EQ(read_site(folder / "cloud.obj").discs.size(), 16u);
}

TEST(Site, UnitAndUpAxisTurnAMeshAndACloudAlike) {
  const TemporaryFolder folder;
  const std::vector<TriangleMesh> box{make_box({1, 2, 3})};
  const auto points = sample_surface(box, {.spacing = 0.05}).points;
  write_pcd({.points = points, .rings = 1, .columns = static_cast<int>(points.size())}, folder / "box.pcd");
  const auto mesh = write(folder, "t.obj", kTetrahedron);
  for (const auto& [axis, size] : {std::pair(UpAxis::x, Eigen::Vector3f(2, 3, 1)), {UpAxis::y, {1, 3, 2}}, {UpAxis::z, {1, 2, 3}}}) {
    const SiteOptions options{.world = {}, .unit = 0.5, .up_axis = axis, .discs = {}};
    EXPECT_TRUE(bounds(merged(read_site(mesh, options).meshes, "")).sizes().isApprox(0.5f * size));
    const DiscCloud discs = read_site(folder / "box.pcd", options).discs;
    Eigen::AlignedBox3f box_of_centers;
    for (const Eigen::Vector3f& center : discs.centers) box_of_centers.extend(center);
    EXPECT_TRUE(box_of_centers.sizes().isApprox(0.5f * size, 1e-3f)) << box_of_centers.sizes().transpose();
  }
}

TEST(Site, OptionsOfAnotherKindOfSiteAreRefused) {
  const TemporaryFolder folder;
  const auto sdf = write(folder, "w.sdf", world(model(shape(kBox))));
  const std::string told = "w.sdf: is a world, whose unit and up axis SDF lays down: --unit and --up are for meshes and point clouds";
  EXPECT_EQ(fault_of([&] { read_site(sdf, {.world = {}, .unit = 2.0, .up_axis = {}, .discs = {}}); }), told);
  EXPECT_EQ(fault_of([&] { read_site(sdf, {.world = {}, .unit = {}, .up_axis = UpAxis::y, .discs = {}}); }), told);
  SiteOptions thin;
  thin.discs.thinning = 0.1;
  EXPECT_EQ(fault_of([&] { read_site(sdf, thin); }), "w.sdf: is no point cloud, and --thin is for these");
  SiteOptions level;
  level.level = true;
  EXPECT_EQ(fault_of([&] { read_site(sdf, level); }), "w.sdf: is no point cloud, and --level is for these");
}

TEST(Site, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_of([&] { read_site(folder / "missing.pcd"); }), "missing.pcd: no such file");
  EXPECT_THAT(fault_of([&] { read_site(write(folder, "a.txt", "hello world\n")); }),
              testing::StartsWith("a.txt: is no site that is known"));
  std::filesystem::create_directory(folder / "folder.pcd");
  EXPECT_EQ(fault_of([&] { read_site(folder / "folder.pcd"); }), "folder.pcd: not a regular file");
  for (const char* name : {"empty.sdf", "empty.world"}) {
    EXPECT_EQ(fault_of([&] { read_site(write(folder, name, "")); }), std::string(name) + ":1:1: not valid XML: no element found");
  }
  EXPECT_THAT(fault_of([&] { read_site(write(folder, "empty", "")); }), testing::StartsWith("empty: is no site that is known"));
  EXPECT_EQ(fault_of([&] { read_site(write(folder, "cut.ply", "ply\nformat ascii 1.0\n")); }), "cut.ply:3: ends within the header");
}

TEST(Site, ACloudThatIsTooFarOffOrTooSmallIsRefused) {
  const TemporaryFolder folder;
  std::vector<Eigen::Vector3f> points(20, {500000.0f, 4000000.0f, 0.0f});
  write_pcd({.points = points, .rings = 1, .columns = 20}, folder / "utm.pcd");
  EXPECT_EQ(fault_of([&] { read_site(folder / "utm.pcd"); }),
            "utm.pcd: has points farther than 100 km from its origin, where single precision blurs them: move it near, or give --unit");
  points.assign(20, {1.0f, 2.0f, 3.0f});
  write_pcd({.points = points, .rings = 1, .columns = 20}, folder / "one.pcd");
  EXPECT_EQ(fault_of([&] { read_site(folder / "one.pcd"); }),
            "one.pcd: of 20 points 1 are left that are finite and differ; surfaces take at least 13");
  points.assign(20, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  write_pcd({.points = points, .rings = 1, .columns = 20}, folder / "nan.pcd");
  EXPECT_EQ(fault_of([&] { read_site(folder / "nan.pcd"); }),
            "nan.pcd: of 20 points 0 are left that are finite and differ; surfaces take at least 13");
}

struct SharedSite {
  const char* name;
  const char* file;
  std::size_t discs;
};

class SharedCloud : public testing::TestWithParam<SharedSite> {};

TEST_P(SharedCloud, IsReadAsASite) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(file, GetParam().file);
  const Site site = read_site(file);
  EXPECT_EQ(site.discs.size(), GetParam().discs);
  EXPECT_TRUE(
      std::ranges::all_of(site.discs.normals, [](const Eigen::Vector3f& normal) { return std::abs(normal.norm() - 1.0f) < 1e-4f; }));
  EXPECT_TRUE(std::ranges::all_of(site.discs.radii, [](float radius) { return radius > 0.0f; }));
}

INSTANTIATE_TEST_SUITE_P(Files, SharedCloud,
                         testing::Values(SharedSite{"PcdCompressed", "scans/room/room_scan1.pcd", 56159},
                                         SharedSite{"PcdAscii", "clouds/outdoor-features.pcd", 62445},
                                         SharedSite{"PcdBinary", "logs/real-hall/scans/full000.pcd", 73452},
                                         SharedSite{"Ply", "clouds/ouster-street.ply", 155000},
                                         SharedSite{"Bin", "logs/kitti-00/000000.bin", 124668}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace alignability
