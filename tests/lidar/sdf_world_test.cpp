// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sdf_world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "lidar/scene.hpp"
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
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Eigen::AlignedBox3f box_of(const World& read) { return bounds(merged(read.meshes, "")); }

void expect_box(const World& read, const Eigen::Vector3f& min, const Eigen::Vector3f& max) {
  EXPECT_LT((box_of(read).min() - min).norm(), 1e-4f) << box_of(read).min().transpose();
  EXPECT_LT((box_of(read).max() - max).norm(), 1e-4f) << box_of(read).max().transpose();
}

TEST(SdfWorld, PlacesABoxByModelLinkAndShape) {
  const TemporaryFolder folder;
  const World read = read_world(write(folder, "w.sdf", world(model(shape(kBox, "0 0 1.5 0 0 0"), "10 20 0 0 0 1.5707963267948966"))));
  ASSERT_EQ(read.meshes.size(), 1u);
  EXPECT_EQ(read.meshes[0].name, "m::l::c");
  expect_box(read, {9, 19.5f, 0}, {11, 20.5f, 3});
  EXPECT_THAT(read.warnings, IsEmpty());
}

TEST(SdfWorld, FollowsRelativePoses) {
  const TemporaryFolder folder;
  const std::string content =
      "<frame name=\"bay\"><pose>5 0 0 0 0 0</pose></frame><model name=\"m\"><pose relative_to=\"bay\">1 0 0 0 0 0</pose>"
      "<link name=\"a\"><pose>0 1 0 0 0 0</pose></link><link name=\"b\"><pose relative_to=\"a\">0 1 0 0 0 0</pose>" +
      shape("<sphere><radius>1</radius></sphere>") + "</link></model>";
  expect_box(read_world(write(folder, "w.sdf", world(content))), {5, 1, -1}, {7, 3, 1});
}

TEST(SdfWorld, KnowsEveryPrimitive) {
  const TemporaryFolder folder;
  const auto extent = [&](const std::string& geometry) -> Eigen::Vector3f {
    return box_of(read_world(write(folder, "w.sdf", world(model(shape(geometry)))))).sizes();
  };
  EXPECT_TRUE(extent("<cylinder><radius>0.5</radius><length>2</length></cylinder>").isApprox(Eigen::Vector3f(1, 1, 2), 1e-4f));
  EXPECT_TRUE(extent("<capsule><radius>0.5</radius><length>2</length></capsule>").isApprox(Eigen::Vector3f(1, 1, 3), 1e-4f));
  EXPECT_TRUE(extent("<ellipsoid><radii>1 2 3</radii></ellipsoid>").isApprox(Eigen::Vector3f(2, 4, 6), 1e-4f));
  EXPECT_TRUE(extent("<sphere><radius>2</radius></sphere>").isApprox(Eigen::Vector3f(4, 4, 4), 1e-4f));
}

TEST(SdfWorld, AVisualPlaneHasItsSizeAndACollisionPlaneNoEnd) {
  const TemporaryFolder folder;
  const std::string plane = "<plane><normal>0 0 1</normal><size>3 4</size></plane>";
  const auto file =
      write(folder, "w.sdf",
            world(model(shape(plane)) + "<model name=\"far\"><link name=\"l\">" + shape(kBox, "30 0 5 0 0 0") + "</link></model>"));
  const World visual = read_world(file, {.model_paths = {}, .geometry = SdfGeometry::visual});
  EXPECT_EQ(visual.meshes[0].name, "m::l::v");
  EXPECT_TRUE(bounds(visual.meshes[0]).sizes().isApprox(Eigen::Vector3f(3, 4, 0), 1e-5f));
  const World collision = read_world(file);
  ASSERT_EQ(collision.meshes.size(), 2u);
  EXPECT_EQ(collision.meshes[1].name, "m::l::c");
  EXPECT_TRUE(bounds(collision.meshes[1]).sizes().isApprox(Eigen::Vector3f(81, 81, 0), 1e-5f));
}

TEST(SdfWorld, APlaneFacesAlongItsNormal) {
  const TemporaryFolder folder;
  const auto file = write(folder, "w.sdf", world(model(shape("<plane><normal>1 0 0</normal><size>3 4</size></plane>", "7 0 0 0 0 0"))));
  const Eigen::AlignedBox3f box = box_of(read_world(file, {.model_paths = {}, .geometry = SdfGeometry::visual}));
  EXPECT_NEAR(box.min().x(), 7, 1e-5);
  EXPECT_NEAR(box.max().x(), 7, 1e-5);
}

TEST(SdfWorld, FindsMeshesBesideItAndScalesThem) {
  const TemporaryFolder folder;
  write(folder, "meshes/t.obj", kTetrahedron);
  const auto file = write(folder, "w.sdf", world(model(shape("<mesh><uri>meshes/t.obj</uri><scale>-1 2 1</scale></mesh>"))));
  const World read = read_world(file);
  expect_box(read, {-1, 0, 0}, {0, 4, 3});
  EXPECT_NEAR(test::volume(read.meshes[0]), 2.0, 1e-5);
}

TEST(SdfWorld, FindsMeshesByEverySchemeOfLocalFiles) {
  const TemporaryFolder folder;
  const auto mesh = write(folder, "models/crate/t.obj", kTetrahedron);
  for (const std::string& uri : {std::string("model://crate/t.obj"), std::string("package://crate/t.obj"), "file://" + mesh.string()}) {
    const World read = read_world(write(folder, "w.sdf", world(model(shape("<mesh><uri>" + uri + "</uri></mesh>")))));
    EXPECT_EQ(read.meshes.size(), 1u) << uri;
  }
}

TEST(SdfWorld, PutsTheMiddleOfASubmeshAtItsOriginWhereToldTo) {
  const TemporaryFolder folder;
  write(folder, "t.obj", "o lid\n" + std::string(kTetrahedron));
  const auto box = [&](const std::string& center) {
    const std::string mesh = "<mesh><uri>t.obj</uri><submesh><name>lid</name><center>" + center + "</center></submesh></mesh>";
    return box_of(read_world(write(folder, "w.sdf", world(model(shape(mesh))))));
  };
  EXPECT_LT((box("false").min() - Eigen::Vector3f(0, 0, 0)).norm(), 1e-5f);
  EXPECT_LT(box("true").center().norm(), 1e-5f);
  EXPECT_LT((box("true").sizes() - Eigen::Vector3f(1, 2, 3)).norm(), 1e-5f);
}

TEST(SdfWorld, IncludesModelsNestedInModels) {
  const TemporaryFolder folder;
  write(folder, "models/crate/model.sdf",
        "<sdf version=\"1.6\"><model name=\"crate\"><link name=\"l\">" + shape("<mesh><uri>model://crate/t.obj</uri></mesh>") +
            "</link></model></sdf>");
  write(folder, "models/crate/t.obj", kTetrahedron);
  const auto file = write(folder, "worlds/w.world",
                          world("<model name=\"one\"><include><uri>model://crate</uri></include><pose>10 0 0 0 0 0</pose></model>"
                                "<include><name>two</name><uri>model://crate</uri><pose>20 0 0 0 0 0</pose></include>"));
  const World read = read_world(file);
  ASSERT_EQ(read.meshes.size(), 2u);
  EXPECT_EQ(read.meshes[0].name, "one::crate::l::c");
  EXPECT_EQ(read.meshes[1].name, "two::l::c");
  expect_box(read, {10, 0, 0}, {21, 2, 3});
}

TEST(SdfWorld, LooksForModelsInGivenFoldersAndInTheEnvironment) {
  const TemporaryFolder folder;
  write(folder, "elsewhere/crate/model.sdf",
        "<sdf version=\"1.6\"><model name=\"crate\"><link name=\"l\">" + shape(kBox) + "</link></model></sdf>");
  const auto file = write(folder, "w/w.world", world("<include><uri>model://crate</uri></include>"));
  EXPECT_THAT(fault_of([&] { read_world(file); }), HasSubstr("w.world:4: "));
  EXPECT_EQ(read_world(file, {.model_paths = {folder / "elsewhere"}}).meshes.size(), 1u);
  ::setenv("GZ_SIM_RESOURCE_PATH", ("/nowhere::" + (folder / "elsewhere").string()).c_str(), 1);
  EXPECT_EQ(read_world(file).meshes.size(), 1u);
  ::unsetenv("GZ_SIM_RESOURCE_PATH");
}

TEST(SdfWorld, ReadsALoneModel) {
  const TemporaryFolder folder;
  const World read = read_world(write(folder, "model.sdf", "<sdf version=\"1.7\">" + model(shape(kBox), "5 0 0 0 0 0") + "</sdf>"));
  expect_box(read, {4.5f, -1, -1.5f}, {5.5f, 1, 1.5f});
}

TEST(SdfWorld, NamesWhatItLeavesOut) {
  const TemporaryFolder folder;
  const auto file = write(folder, "w.sdf", world(model(shape("<heightmap><uri>hills.png</uri></heightmap>"))));
  const World read = read_world(file);
  EXPECT_THAT(read.meshes, IsEmpty());
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("w.sdf:4: 'm::l::c' is left out: geometry 'heightmap' is not supported")));
  const std::string road = "<road name=\"r\"><width>2</width><point>0 0 0</point><point>9 0 0</point></road>";
  EXPECT_THAT(read_world(write(folder, "w.sdf", world(model(shape(kBox)) + road))).warnings,
              ElementsAre(HasSubstr("w.sdf:4: 'road' is left out: not supported")));
}

TEST(SdfWorld, PassesTheLibrarysWarningsOnWithoutPrintingThem) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  const World read = read_world(write(folder, "w.sdf", world("<furniture/>" + model(shape(kBox)))));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("furniture")));
  EXPECT_EQ(read.meshes.size(), 1u);
}

TEST(SdfWorld, DoesNotMindImpossibleMasses) {
  const TemporaryFolder folder;
  const std::string inertial = "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>100</izz></inertia></inertial>";
  EXPECT_EQ(read_world(write(folder, "w.sdf", world(model(inertial + shape(kBox))))).meshes.size(), 1u);
}

TEST(SdfWorld, IncludesModelsThatIncludeModels) {
  const TemporaryFolder folder;
  write(folder, "models/outer_crate/model.sdf",
        "<sdf version=\"1.7\"><model name=\"outer\"><include><uri>model://inner_crate</uri></include></model></sdf>");
  write(folder, "models/inner_crate/model.sdf", "<sdf version=\"1.7\">" + model(shape(kBox)) + "</sdf>");
  const auto file = write(folder, "w.sdf", world("<include><uri>model://outer_crate</uri></include>"));
  EXPECT_EQ(read_world(file).meshes.at(0).name, "outer::m::l::c");
}

TEST(SdfWorld, ReadsTheSmallWarehouse) {
  ALIGNABILITY_REQUIRE_SHARED_DATA(folder, "worlds/aws-small-warehouse/worlds");
  for (const SdfGeometry geometry : {SdfGeometry::collision, SdfGeometry::visual}) {
    const World roofed = read_world(folder / "small_warehouse.world", {.model_paths = {}, .geometry = geometry});
    const World open = read_world(folder / "no_roof_small_warehouse.world", {.model_paths = {}, .geometry = geometry});
    EXPECT_EQ(roofed.meshes.size(), 26u);
    EXPECT_EQ(open.meshes.size(), 25u);
    EXPECT_THAT(roofed.warnings, IsEmpty());
    EXPECT_LT((box_of(roofed).sizes() - Eigen::Vector3f(14.0f, 20.92f, 10.21f)).norm(), 0.05f);
    const Scene scene(roofed.meshes);
    EXPECT_TRUE(scene.is_free({0.5f, 0.3f, 1.5f}, 0.3f));
    // The visual walls are open sheets, the collision walls are solid.
    EXPECT_EQ(scene.is_free({-6.92f, 9, 4}, 0.0f), geometry == SdfGeometry::visual);
    EXPECT_TRUE(scene.is_free({0, 0, 12}, 0.3f));
  }
}

}  // namespace
}  // namespace alignability
