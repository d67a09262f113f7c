// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lidar/sdf_world.hpp"
#include "tests/lidar/fixtures.hpp"
#include "tests/lidar/sdf_text.hpp"

namespace alignability {
namespace {

using test::fault_of;
using test::kBox;
using test::model;
using test::shape;
using test::TemporaryFolder;
using test::world;
using test::write;

struct Malformed {
  std::string sdf;
  const char* message;
};

class MalformedSdf : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedSdf, IsRefusedAtItsPlace) {
  const TemporaryFolder folder;
  write(folder, "t.obj", test::kTetrahedron);
  write(folder, "bad.obj", "nothing");
  EXPECT_EQ(fault_of([&] { read_world(write(folder, "w.sdf", GetParam().sdf)); }), GetParam().message);
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string with(std::string text, const std::string& replaced, const std::string& by) {
  return text.replace(text.find(replaced), replaced.size(), by);
}

const std::string kGood = world("\n" + model("\n" + shape(kBox)));  // the shape on line 6

std::string with_geometry(const std::string& geometry) { return with(kGood, kBox, "\n" + geometry); }

INSTANTIATE_TEST_SUITE_P(
    Document, MalformedSdf,
    testing::Values(Malformed{"", "w.sdf:1:1: not valid XML: no element found"},
                    Malformed{"<sdf version=\"1.7\"><world", "w.sdf:1:20: not valid XML: unclosed token"},
                    Malformed{with(kGood, "</link>", "</lnik>"), "w.sdf:6:209: not valid XML: mismatched tag"},
                    Malformed{"<!-- a page -->\n<html/>", "w.sdf:2:1: expected <sdf>, not <html>"},
                    Malformed{"<sdf version=\"1.7\"></sdf>", "w.sdf: holds neither a world nor a model"},
                    Malformed{with(kGood, " version=\"1.7\"", ""), "w.sdf:2:1: <sdf> has no 'version'"},
                    Malformed{with(kGood, "1.7", "9.9"), "w.sdf:2:1: 'version' is '9.9'; 1.0 to 1.9 are read"},
                    Malformed{with(kGood, "1.7", "1.10"), "w.sdf:2:1: 'version' is '1.10'; 1.0 to 1.9 are read"},
                    Malformed{with(kGood, "1.7", "1.x"), "w.sdf:2:1: 'version' is '1.x'; 1.0 to 1.9 are read"},
                    Malformed{with(kGood, "1.7", "1.-1"), "w.sdf:2:1: 'version' is '1.-1'; 1.0 to 1.9 are read"},
                    Malformed{with(kGood, "1.7", "1.7.1"), "w.sdf:2:1: 'version' is '1.7.1'; 1.0 to 1.9 are read"},
                    Malformed{"<sdf version=\"1.7\">" + repeated("<world>", 128), "w.sdf:1:909: elements are nested deeper than 128"},
                    Malformed{with(kGood, "1.7", "new"), "w.sdf:2:1: 'version' is 'new'; 1.0 to 1.9 are read"},
                    Malformed{with(kGood, " name=\"w\"", ""),
                              "w.sdf:3: Required attribute[name] in element[world] is not specified in SDF."},
                    Malformed{world(model(shape(kBox)) + model(shape(kBox))), "w.sdf: model with name[m] already exists."}));

INSTANTIATE_TEST_SUITE_P(
    Pose, MalformedSdf,
    testing::Values(
        Malformed{with(kGood, "<pose>0 0 0 0 0 0", "<pose>0 0 zero 0 0 0"),
                  "w.sdf:5: Error reading element <pose>: Invalid argument. Unable to set value [0 0 zero 0 0 0] for key [pose]."},
        Malformed{
            with(kGood, "<pose>0 0 0 0 0 0", "<pose>0 0 0 0 0"),
            "w.sdf:5: Error reading element <pose>: The value for //pose[@rotation_format='euler_rpy'] must have 6 values, but 5 were "
            "found instead in '0 0 0 0 0'."},
        Malformed{with(kGood, "<pose>0 0 0 0 0 0", "<pose>0 0 nan 0 0 0"),
                  "w.sdf:5: Error reading element <pose>: Pose values must be finite."},
        Malformed{with(kGood, "<pose>", "<pose relative_to=\"bay\">"),
                  "w.sdf: relative_to name[bay] specified by model with name[m] does not match a model or frame name in world with "
                  "name[w]."},
        Malformed{world("<frame name=\"a\"><pose relative_to=\"b\"/></frame><frame name=\"b\"><pose relative_to=\"a\"/></frame>"),
                  "w.sdf: PoseRelativeToGraph cycle detected, already visited vertex [a]."}));

INSTANTIATE_TEST_SUITE_P(
    Geometry, MalformedSdf,
    testing::Values(Malformed{with_geometry("<box><size>1 -2 3</size></box>"), "w.sdf:6: the size of a box must be greater than 0"},
                    Malformed{with_geometry("<box><size>a b c</size></box>"),
                              "w.sdf:7: Error reading element <size>: Unknown error. Unable to set value [a b c ] for key[size]"},
                    Malformed{with_geometry("<box><size>nan 1 1</size></box>"),
                              "w.sdf:7: Error reading element <size>: Unknown error. Unable to set value [nan 1 1 ] for key[size]"},
                    Malformed{with_geometry("<box><size>1 1</size></box>"),
                              "w.sdf:7: Error reading element <size>: Unknown error. Unable to set value [1 1 ] for key[size]"},
                    Malformed{with_geometry("<sphere><radius>0</radius></sphere>"),
                              "w.sdf:6: the radius of a sphere must be greater than 0"},
                    Malformed{with_geometry("<cylinder><radius>1</radius><length>0</length></cylinder>"),
                              "w.sdf:6: radius and length of a cylinder must be greater than 0"},
                    Malformed{with_geometry("<cylinder><radius>wide</radius><length>1</length></cylinder>"),
                              "w.sdf:7: Error reading element <radius>: Invalid argument. Unable to set value [wide ] for key[radius]."},
                    Malformed{with_geometry("<capsule><radius>-1</radius><length>1</length></capsule>"),
                              "w.sdf:6: radius and length of a capsule must be greater than 0"},
                    Malformed{with_geometry("<ellipsoid><radii>1 0 1</radii></ellipsoid>"),
                              "w.sdf:6: the radii of an ellipsoid must be greater than 0"},
                    Malformed{with_geometry("<plane><normal>0 0 0</normal><size>1 1</size></plane>"),
                              "w.sdf:6: the length of a plane's normal must be greater than 0"}));

INSTANTIATE_TEST_SUITE_P(
    File, MalformedSdf,
    testing::Values(
        Malformed{with_geometry("<mesh><uri>model://no/such.dae</uri></mesh>"),
                  "w.sdf:7: no mesh 'model://no/such.dae' in any folder of models"},
        Malformed{with_geometry("<mesh/>"), "w.sdf:7: a mesh without <uri>"},
        Malformed{with_geometry("<mesh><uri>t.obj</uri><scale>1 0 1</scale></mesh>"), "w.sdf:7: the scale of a mesh must have no zero"},
        Malformed{with_geometry("<mesh><uri>t.obj</uri><submesh><name>lid</name></submesh></mesh>"), "t.obj: has no triangles named 'lid'"},
        Malformed{with(with_geometry("<mesh><uri>t.obj</uri></mesh>"), "<pose>0 0 0", "<pose>1e39 0 0"),
                  "w.sdf:7: 'm::l::c' does not lie at finite coordinates"},
        Malformed{world("<include><uri> </uri></include>"), "w.sdf:4: no model '' in any folder of models"},
        Malformed{world("<include><uri>model://</uri></include>"), "w.sdf:4: no model 'model://' in any folder of models"},
        Malformed{with_geometry("<mesh><uri>bad.obj</uri></mesh>"), "bad.obj: cannot be read as a mesh: OBJ-file is too small."},
        Malformed{world("<include><uri>model://no_such</uri></include>"), "w.sdf:4: no model 'model://no_such' in any folder of models"},
        Malformed{world("<include><uri>https://example.org/crate</uri></include>"),
                  "w.sdf:4: no model 'https://example.org/crate' in any folder of models"}));

TEST(SdfErrors, AMissingFileIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_of([&] { read_world(folder / "missing.sdf"); }), "missing.sdf: no such file");
}

TEST(SdfErrors, WhatIsWrongInAnIncludedModelIsShownThere) {
  const TemporaryFolder folder;
  const auto file = write(folder, "w.sdf", world("<include><uri>model://crate</uri></include>"));
  const auto fault = [&](const std::string& crate) {
    write(folder, "models/crate/model.sdf", crate);
    return fault_of([&] { read_world(file); });
  };
  EXPECT_EQ(fault("<sdf version=\"1.7\">\n" + model(shape("<mesh><uri>no.dae</uri></mesh>")) + "</sdf>"),
            "model.sdf:2: no mesh 'no.dae' in any folder of models");
  EXPECT_EQ(fault("<sdf version=\"1.7\">\n<model"), "model.sdf:2:1: not valid XML: unclosed token");
  EXPECT_EQ(fault("<sdf version=\"2.0\"/>"), "model.sdf:1:1: 'version' is '2.0'; 1.0 to 1.9 are read");
  EXPECT_EQ(fault("<sdf version=\"1.7\"><model name=\"m\">\n<include><uri>model://crate</uri></include></model></sdf>"),
            "model.sdf:2: 'model://crate' includes itself");
}

TEST(SdfErrors, AModelThatIncludesItselfThroughAnotherIsRefused) {
  const TemporaryFolder folder;
  write(folder, "models/outer_crate/model.sdf",
        "<sdf version=\"1.7\"><model name=\"outer\"><include><uri>model://inner_crate</uri></include></model></sdf>");
  write(folder, "models/inner_crate/model.sdf",
        "<sdf version=\"1.7\"><model name=\"inner\">\n<include><uri>model://outer_crate</uri></include></model></sdf>");
  EXPECT_EQ(fault_of([&] { read_world(write(folder, "w.sdf", world("<include><uri>model://outer_crate</uri></include>"))); }),
            "model.sdf:2: 'model://outer_crate' includes itself");
}

}  // namespace
}  // namespace alignability
