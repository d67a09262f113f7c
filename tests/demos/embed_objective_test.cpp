// SPDX-License-Identifier: BSD-3-Clause
// What the README shows to those who embed the objective is what is built, and does what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/cli/program.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

using testing::HasSubstr;

const std::filesystem::path kSource = ALIGNABILITY_SOURCE_DIR;

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(kSource / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(EmbedObjective, TakesTheDetourOnWhichTheRobotStaysLocalized) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory_symlink(kSource / "maps", folder / "maps");
  const test::Outcome outcome = test::run_program({}, folder / "");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  ASSERT_GT(outcome.out.size(), 1u);
  // OMPL's own lines come before.
  const std::size_t last_line = outcome.out.find_last_of('\n', outcome.out.size() - 2) + 1;
  double length = 0.0;
  double cost = 0.0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str() + last_line, "%lf m long, cost %lf", &length, &cost), 2) << outcome.out;
  EXPECT_GT(length, 55.0) << "the shortest path, through the corridor, is 50.9 m long";
  EXPECT_GE(cost, length);
  EXPECT_LT(cost, 1.1 * length) << "a metre of the corridor costs 6";
}

TEST(EmbedObjective, IsShownByTheReadme) {
  const std::string program = contents("demos/embed_objective.cpp");
  ASSERT_THAT(program, HasSubstr("#include"));
  EXPECT_THAT(contents("README.md"), HasSubstr("```cpp\n" + program.substr(program.find("#include")) + "```\n"));
}

TEST(EmbedObjective, IsBuiltAsTheReadmeShows) {
  const std::string project = contents("tests/consumer/CMakeLists.txt");
  ASSERT_THAT(project, HasSubstr("find_package"));
  EXPECT_THAT(contents("README.md"), HasSubstr("```cmake\n" + project + "```\n"));
}

}  // namespace
}  // namespace alignability
