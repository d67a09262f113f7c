// SPDX-License-Identifier: BSD-3-Clause
#include "planner/route_file.hpp"

#include <gtest/gtest.h>

#include "core/range.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

using Path = std::vector<Pose2>;

class PathTable : public testing::Test {
 protected:
  Route read(const std::string& text) const { return read_route(folder.write("path.csv", text), {}); }
  std::string error(const std::string& text) const {
    const std::string message = test::thrown_message([&] { read(text); });
    const std::string file = (folder / "path.csv").string();
    return message.starts_with(file) ? message.substr(file.size()) : message;
  }

  test::TemporaryFolder folder;
};

TEST_F(PathTable, IsReadByTheNamesOfItsColumns) {
  const Path path{{1, 2, 0.5}, {3, 4, -0.5}};
  EXPECT_EQ(read("x,y,yaw,s,alpha,risk\n1,2,0.5,0,0.3,1\n3,4,-0.5,2.8,,1\n").path, path);
  EXPECT_EQ(read("t, yaw, y, x\n0, 0.5, 2, 1\n1, -0.5, 4, 3\n").path, path);
  EXPECT_EQ(read("\"x\";\"y\";\"yaw\"\n\"1\";\"2\";\"0.5\"\n3;4;-0.5\n").path, path);
  EXPECT_EQ(read("x\ty\tyaw\n1\t2\t0.5\n3\t4\t-0.5").path, path);
  EXPECT_TRUE(read("x,y,yaw\n1,2,0.5\n").remarks.empty());
}

TEST_F(PathTable, IsReadWithoutNames) {
  EXPECT_EQ(read("1,2,0.5\n+3,4e0,-.5\n").path, (Path{{1, 2, 0.5}, {3, 4, -0.5}}));
  EXPECT_EQ(read("  1   2 0.5  \n3 4 -0.5").path, (Path{{1, 2, 0.5}, {3, 4, -0.5}}));
}

TEST_F(PathTable, LeavesCommentsAndBlankLinesAside) {
  EXPECT_EQ(read("\xef\xbb\xbf# from the lorry\r\n\r\n x , y , yaw \r\n  # and on\r\n1,2,0.5\r\n\r\n3,4,-0.5\r\n\r\n").path,
            (Path{{1, 2, 0.5}, {3, 4, -0.5}}));
}

TEST_F(PathTable, WithoutYawTheRobotLooksWhereItGoesAndSaysSo) {
  const double up = std::numbers::pi / 2.0;
  for (const std::string text : {"x,y\n1,1\n4,1\n4,5\n", "1,1\n4,1\n4,5\n"}) {
    const Route route = read(text);
    EXPECT_EQ(route.path, (Path{{1, 1, 0}, {4, 1, 0}, {4, 1, up}, {4, 5, up}}));
    EXPECT_EQ(route.remarks, std::vector<std::string>{"there is no yaw: the robot looks where it goes"});
  }
}

TEST_F(PathTable, RemarksOnYawThatLooksLikeDegrees) {
  EXPECT_EQ(read("1,1,90\n4,1,0\n").remarks, std::vector<std::string>{"yaw is read in radians, and exceeds a full turn"});
}

TEST_F(PathTable, IsReadToTheLastBit) {
  const Path path{{1.0 / 3.0, -1e-17, 0.1}, {12345.678901234567, 2e5 / 7.0, -3.0}};
  std::string text = "x,y,yaw\n";
  for (const Pose2& pose : path) text += to_text(pose.x) + ',' + to_text(pose.y) + ',' + to_text(pose.yaw) + '\n';
  EXPECT_EQ(read(text).path, path);
}

TEST_F(PathTable, IsRefusedWhereItIsWrong) {
  struct Fault {
    const char* text;
    const char* message;
  };
  const Fault faults[] = {
      {"", ": holds no places: a path has a line with x, y and, where it has one, yaw for each"},
      {"# nothing\n\n", ": holds no places: a path has a line with x, y and, where it has one, yaw for each"},
      {"x,y\n", ": names its columns, but holds no places"},
      {"x,z\n1,2\n", ":1:1: there is no column 'y' among the names: a path needs x, y and, where it has one, yaw"},
      {"a,b,x,y,x\n", ":1:9: there is another column 'x'"},
      {"1,2,3,4\n", ":1:1: 4 columns need a line before them that names x, y and, where there is one, yaw"},
      {"1\n", ":1:1: 1 columns need a line before them that names x, y and, where there is one, yaw"},
      {"x,y\n1,2\n\n3,4,5\n", ":4:1: there must be 2 values, as on the first line, not 3"},
      {"x,y\n1,2\n3\n", ":3:1: there must be 2 values, as on the first line, not 1"},
      {"x,y\n1, two\n", ":2:4: 'y' must be a number, not 'two'"},
      {"x,y\n1,\n", ":2:3: 'y' must be a number, not ''"},
      {"x,y\n1,2,\n", ":2:1: there must be 2 values, as on the first line, not 3"},
      {"1,2\n1,2m\n", ":2:3: 'y' must be a number, not '2m'"},
      {"1,2\nnan,2\n", ":2:1: 'x' must be from -1e+07 to 1e+07, not 'nan'"},
      {"1,2\n1,inf\n", ":2:3: 'y' must be from -1e+07 to 1e+07, not 'inf'"},
      {"1,2\n1,2e7\n", ":2:3: 'y' must be from -1e+07 to 1e+07, not '2e7'"},
      {"1,2\n1,1e999\n", ":2:3: 'y' must be a number, not '1e999'"},
      {"1,2,0\n1,2,nan\n", ":2:5: 'yaw' must be a finite number, not 'nan'"},
      {"x;y\n1,5;2\n", ":2:1: 'x' must be a number, not '1,5'"},
      {"1,2\n1,2\n", ": stays in one place, and has no yaw there"},
      {"0,0\n1e6,0\n", ": the path is 1e+06 m long; at most 1e+05 m are scored"},
  };
  for (const Fault& fault : faults) EXPECT_EQ(error(fault.text), fault.message) << fault.text;
}

TEST_F(PathTable, IsRefusedWhenItIsNoRouteAtAll) {
  const auto message = [&](const std::string& name, const RouteFileOptions& options = {}) {
    return test::thrown_message([&] { read_route(folder / name, options); });
  };
  folder.write("path.png", "1,2\n3,4\n");
  folder.write("path.txt", "1,2\n3,4\n");
  EXPECT_EQ(message("path.png"), (folder / "path.png").string() + ": is no route: a path is .csv or .txt, a graph .geojson, .json or .lif");
  EXPECT_EQ(message("missing.csv"), (folder / "missing.csv").string() + ": no such file");
  const std::string choice = (folder / "path.txt").string() + ": a vehicle and a map are chosen from LIF files only";
  EXPECT_EQ(message("path.txt", {.vehicle = "truck", .map = std::nullopt}), choice);
  EXPECT_EQ(message("path.txt", {.vehicle = std::nullopt, .map = "hall"}), choice);
}

}  // namespace
}  // namespace alignability
