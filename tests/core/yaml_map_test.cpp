// SPDX-License-Identifier: BSD-3-Clause
#include "core/yaml_map.hpp"

#include <gmock/gmock.h>

#include "tests/core/temporary_folder.hpp"

namespace alignability {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Optional;

YamlMap parse(const std::string& text) { return YamlMap::from_text(text, "maps/hall/problem.yaml"); }

TEST(YamlMap, ReadsANumberHoweverItIsWritten) {
  YamlMap yaml = parse("a: 1\nb: -2.5\nc: 1e-3\nd: .5\ne: +3\nf: '4'\n");
  EXPECT_EQ(yaml.number("a", kFinite), 1.0);
  EXPECT_EQ(yaml.number("b", kFinite), -2.5);
  EXPECT_EQ(yaml.number("c", kFinite), 1e-3);
  EXPECT_EQ(yaml.number("d", kFinite), 0.5);
  EXPECT_EQ(yaml.number("e", kFinite), 3.0);
  EXPECT_THAT(yaml.find_number("f", kFinite), Optional(4.0));
  yaml.finish();
}

TEST(YamlMap, ReadsADecimalToItsNearestDouble) {
  YamlMap yaml = parse("a: 0.05\nb: 0.1\nc: -23.300000\nd: 0.30000000000000004\n");
  EXPECT_EQ(yaml.number("a", kFinite), 0.05);
  EXPECT_EQ(yaml.number("b", kFinite), 0.1);
  EXPECT_EQ(yaml.number("c", kFinite), -23.3);
  EXPECT_EQ(yaml.number("d", kFinite), 0.30000000000000004);
}

TEST(YamlMap, GivesNulloptForWhatIsAbsent) {
  YamlMap yaml = parse("other: 1\n");
  EXPECT_EQ(yaml.find_number("a", kFinite), std::nullopt);
  EXPECT_EQ(yaml.find_integer("a", 0, 1), std::nullopt);
  EXPECT_EQ(yaml.find_text("a"), std::nullopt);
  EXPECT_EQ(yaml.find_path("a"), std::nullopt);
  EXPECT_EQ(yaml.find_numbers("a", kFinite), std::nullopt);
  EXPECT_EQ(yaml.find_numbers("a", 3, kFinite), std::nullopt);
  EXPECT_EQ(yaml.find_texts("a"), std::nullopt);
  EXPECT_FALSE(yaml.find_map("a").has_value());
  EXPECT_FALSE(yaml.find_maps("a").has_value());
  EXPECT_FALSE(yaml.find_points("a", kFinite).has_value());
  constexpr std::pair<const char*, int> kChoices[] = {{"one", 1}};
  EXPECT_EQ(yaml.find_choice("a", kChoices), std::nullopt);
  EXPECT_FALSE(yaml.is_sequence("a"));
}

TEST(YamlMap, ReadsIntegersUpToTheLimits) {
  YamlMap yaml = parse("a: 9223372036854775807\nb: -9223372036854775808\nc: 0\n");
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(yaml.integer("a", kMin, kMax), kMax);
  EXPECT_EQ(yaml.integer("b", kMin, kMax), kMin);
  EXPECT_THAT(yaml.find_integer("c", 0, 0), Optional(0));
}

TEST(YamlMap, ReadsTextAndKeepsWhatIsQuoted) {
  YamlMap yaml = parse("a: Velodyne HDL-32E\nb: \"x: #1\"\nc: ''\nd: |\n  two\n    lines\n");
  EXPECT_EQ(yaml.text("a"), "Velodyne HDL-32E");
  EXPECT_EQ(yaml.text("b"), "x: #1");
  EXPECT_EQ(yaml.text("c"), "");
  EXPECT_EQ(yaml.text("d"), "two\n  lines\n");
}

TEST(YamlMap, ResolvesAPathAgainstItsOwnFolder) {
  YamlMap yaml = parse("a: map.pgm\nb: ../up.pgm\nc: /abs/map.pgm\n");
  EXPECT_EQ(yaml.path("a"), "maps/hall/map.pgm");
  EXPECT_EQ(yaml.path("b"), "maps/hall/../up.pgm");
  EXPECT_EQ(yaml.path("c"), "/abs/map.pgm");
  EXPECT_EQ(YamlMap::from_text("a: map.pgm", "here.yaml").path("a"), "map.pgm");
}

TEST(YamlMap, ReadsLists) {
  YamlMap yaml = parse("a: [1, 2.5, -3]\nb:\n  - one\n  - two\nc: []\n");
  EXPECT_TRUE(yaml.is_sequence("a"));
  EXPECT_TRUE(yaml.is_sequence("b"));
  EXPECT_THAT(yaml.find_numbers("a", kFinite), Optional(ElementsAre(1.0, 2.5, -3.0)));
  EXPECT_THAT(yaml.numbers("a", 3, kFinite), ElementsAre(1.0, 2.5, -3.0));
  EXPECT_THAT(yaml.find_texts("b"), Optional(ElementsAre("one", "two")));
  EXPECT_THAT(yaml.find_numbers("c", kFinite), Optional(IsEmpty()));
  yaml.finish();
}

TEST(YamlMap, ReadsAChoiceByItsName) {
  enum class Space { r2, se2 };
  constexpr std::pair<const char*, Space> kSpaces[] = {{"r2", Space::r2}, {"se2", Space::se2}};
  YamlMap yaml = parse("space: se2\n");
  EXPECT_THAT(yaml.find_choice("space", kSpaces), Optional(Space::se2));
}

TEST(YamlMap, ReadsMapsInMaps) {
  YamlMap yaml = parse("robot: {radius: 0.6}\nrisk:\n  weight: 5\n");
  YamlMap robot = yaml.map("robot");
  EXPECT_EQ(robot.number("radius", kPositive), 0.6);
  robot.finish();
  auto risk = yaml.find_map("risk");
  ASSERT_TRUE(risk.has_value());
  EXPECT_EQ(risk->number("weight", kNotNegative), 5.0);
  EXPECT_EQ(risk->file(), "maps/hall/problem.yaml");
  risk->finish();
  yaml.finish();
}

TEST(YamlMap, FinishesWhenEveryKeyWasAskedForEvenIfAbsentOnesWereToo) {
  YamlMap yaml = parse("a: 1\n");
  yaml.find_number("a", kFinite);
  yaml.find_number("b", kFinite);
  EXPECT_NO_THROW(yaml.finish());
}

TEST(YamlMap, AskingWhetherAKeyIsAListIsNotAskingForIt) {
  YamlMap yaml = parse("a: [1]\n");
  EXPECT_TRUE(yaml.is_sequence("a"));
  EXPECT_THROW(yaml.finish(), InputError);
}

TEST(YamlMap, TakesAnEmptyMap) { EXPECT_NO_THROW(parse("{}").finish()); }

TEST(YamlMap, FollowsAnAlias) {
  YamlMap yaml = parse("a: &a [1, 2]\nb: *a\n");
  EXPECT_THAT(yaml.numbers("a", 2, kFinite), ElementsAre(1.0, 2.0));
  EXPECT_THAT(yaml.numbers("b", 2, kFinite), ElementsAre(1.0, 2.0));
  yaml.finish();
}

TEST(YamlMap, ReadsAFile) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.yaml", "\xEF\xBB\xBF# with a byte order mark, and Windows' line ends\r\nimage: map.pgm\r\nseed: 3\r\n");
  YamlMap yaml = YamlMap::from_file(file);
  EXPECT_EQ(yaml.path("image"), folder / "map.pgm");
  EXPECT_EQ(yaml.integer("seed", 0, 9), 3);
  yaml.finish();
}

}  // namespace
}  // namespace alignability
