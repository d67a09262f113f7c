// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "core/yaml_map.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

using test::TemporaryFolder;
using test::thrown_message;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::pair<const char*, int> kSpaces[] = {{"r2", 0}, {"se2", 1}, {"dubins", 2}};

// Asks for one key of every kind.
void read_all(const std::string& text) {
  YamlMap yaml = YamlMap::from_text(text, "f.yaml");
  yaml.find_number("number", kPositive);
  yaml.find_integer("integer", 1, 9);
  yaml.find_text("text");
  yaml.find_path("path");
  yaml.find_numbers("numbers", kFinite);
  yaml.find_numbers("point", 2, kShare);
  yaml.find_texts("texts");
  yaml.find_choice("space", kSpaces);
  if (auto map = yaml.find_map("map")) {
    map->number("inner", kFinite);
    map->finish();
  }
  yaml.finish();
}

struct Fault {
  const char* text;
  const char* message;
};

class YamlMapRefuses : public ::testing::TestWithParam<Fault> {};

TEST_P(YamlMapRefuses, AtTheLineAndColumn) {
  SCOPED_TRACE(GetParam().text);
  EXPECT_EQ(thrown_message([&] { read_all(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(Numbers, YamlMapRefuses,
                         ::testing::Values(Fault{"number: far", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"text: a\nnumber:", "f.yaml:2:1: 'number' must be a number"},
                                           Fault{"number: 1m", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: 1 2", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: 1,5", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: true", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: [1]", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: {a: 1}", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"\n\n  number:    0", "f.yaml:3:14: 'number' must be greater than 0, not 0"},
                                           Fault{"number: -1e-300", "f.yaml:1:9: 'number' must be greater than 0, not -1e-300"},
                                           Fault{"number: .nan", "f.yaml:1:9: 'number' must be greater than 0, not .nan"},
                                           Fault{"number: .inf", "f.yaml:1:9: 'number' must be greater than 0, not .inf"},
                                           Fault{"number: -.Inf", "f.yaml:1:9: 'number' must be greater than 0, not -.Inf"},
                                           Fault{"number: nan", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: inf", "f.yaml:1:9: 'number' must be a number"},
                                           Fault{"number: 1e400", "f.yaml:1:9: 'number' must be a number"}));

INSTANTIATE_TEST_SUITE_P(Integers, YamlMapRefuses,
                         ::testing::Values(Fault{"integer: 3.0", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 3.0"},
                                           Fault{"integer: 0", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 0"},
                                           Fault{"integer: 10", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 10"},
                                           Fault{"integer: 1e0", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 1e0"},
                                           Fault{"integer: 0x5", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 0x5"},
                                           Fault{"integer: 99999999999999999999",
                                                 "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not 99999999999999999999"},
                                           Fault{"integer: ''", "f.yaml:1:10: 'integer' must be a whole number from 1 to 9, not "},
                                           Fault{"integer: [3]", "f.yaml:1:10: 'integer' must be a whole number"}));

INSTANTIATE_TEST_SUITE_P(
    WordsAndLists, YamlMapRefuses,
    ::testing::Values(Fault{"text: [a]", "f.yaml:1:7: 'text' must be a word"}, Fault{"text:", "f.yaml:1:1: 'text' must be a word"},
                      Fault{"text: ~", "f.yaml:1:7: 'text' must be a word"}, Fault{"path: ''", "f.yaml:1:7: 'path' must name a file"},
                      Fault{"numbers: 3", "f.yaml:1:10: 'numbers' must be a list of numbers"},
                      Fault{"numbers: [1, two]", "f.yaml:1:14: 'numbers' must be a number"},
                      Fault{"numbers: [1, [2]]", "f.yaml:1:14: 'numbers' must be a number"},
                      Fault{"numbers:\n  - 1\n  - .nan", "f.yaml:3:5: 'numbers' must be a finite number, not .nan"},
                      Fault{"point: [0.5]", "f.yaml:1:8: 'point' must be a list of 2 numbers, not 1"},
                      Fault{"point: [0, 1, 0]", "f.yaml:1:8: 'point' must be a list of 2 numbers, not 3"},
                      Fault{"point: [0.5, 1.5]", "f.yaml:1:14: 'point' must be from 0 to 1, not 1.5"},
                      Fault{"texts: alpha", "f.yaml:1:8: 'texts' must be a list of words"},
                      Fault{"texts: [a, [b]]", "f.yaml:1:12: 'texts' must be a list of words"},
                      Fault{"space: se3", "f.yaml:1:8: 'space' is 'se3', which is none of: r2, se2, dubins (did you mean 'se2'?)"},
                      Fault{"space: torus", "f.yaml:1:8: 'space' is 'torus', which is none of: r2, se2, dubins"}));

INSTANTIATE_TEST_SUITE_P(Maps, YamlMapRefuses,
                         ::testing::Values(Fault{"map: 3", "f.yaml:1:6: 'map' must hold 'key: value' pairs"},
                                           Fault{"map: [1]", "f.yaml:1:6: 'map' must hold 'key: value' pairs"},
                                           Fault{"map:\n  inner: x", "f.yaml:2:10: 'inner' must be a number"},
                                           Fault{"map:\n  other: 1", "f.yaml:2:3: missing key 'inner'"},
                                           Fault{"map: {}", "f.yaml:1:6: missing key 'inner'"},
                                           Fault{"map:\n  iner: 1", "f.yaml:2:3: unknown key 'iner' (did you mean 'inner'?)"},
                                           Fault{"map:\n  inner: 1\n  outer: 2", "f.yaml:3:3: unknown key 'outer'"},
                                           Fault{"map: {inner: 1, inner: 1}", "f.yaml:1:17: key 'inner' is given twice"}));

INSTANTIATE_TEST_SUITE_P(Keys, YamlMapRefuses,
                         ::testing::Values(Fault{"number: 1\ntext: a\nnumber: 1", "f.yaml:3:1: key 'number' is given twice"},
                                           Fault{"number: 1\nnubmer: 2", "f.yaml:2:1: unknown key 'nubmer' (did you mean 'number'?)"},
                                           Fault{"velocity: 2", "f.yaml:1:1: unknown key 'velocity'"},
                                           Fault{"? [a, b]\n: 1", "f.yaml:1:3: a key must be a word"},
                                           Fault{"number: 1\n~: 2", "f.yaml:2:1: a key must be a word"}));

INSTANTIATE_TEST_SUITE_P(Roots, YamlMapRefuses,
                         ::testing::Values(Fault{"- 1\n- 2", "f.yaml:1:1: expected 'key: value' pairs"},
                                           Fault{"just words", "f.yaml:1:1: expected 'key: value' pairs"},
                                           Fault{"number: 1\n---\nnumber: 2\n",
                                                 "f.yaml:2:1: a second document begins, where only one is read"}));

TEST(YamlMapErrors, AnEmptyFileHoldsNoPairs) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n"}) {
    EXPECT_THAT(thrown_message([&] { YamlMap::from_text(text, "f.yaml"); }), ::testing::EndsWith(": expected 'key: value' pairs")) << text;
  }
}

TEST(YamlMapErrors, SayWhereTheYamlIsBroken) {
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: 1\nb: [1, 2\nc: 3\n", "f.yaml"); }), StartsWith("f.yaml:3:2: not valid YAML: "));
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: 'open", "f.yaml"); }), StartsWith("f.yaml:1:"));
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: b: c", "f.yaml"); }), StartsWith("f.yaml:1:5: not valid YAML: "));
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: *nobody", "f.yaml"); }), HasSubstr("not valid YAML: "));
}

TEST(YamlMapErrors, SurviveAbsurdNesting) {
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: " + std::string(100000, '['), "f.yaml"); }), HasSubstr("nests more than 64 deep"));
  EXPECT_THAT(thrown_message([] { YamlMap::from_text("a: " + std::string(100000, '{'), "f.yaml"); }), HasSubstr("nests more than 64 deep"));
}

// yaml-cpp 0.7 reads one empty document after the other there, without end.
TEST(YamlMapErrors, SurviveWordsThatBelongToNothing) {
  for (const char* text : {", 0.0]\na: 1\n", "]", "}", ", a"}) {
    EXPECT_THAT(thrown_message([&] { YamlMap::from_text(text, "f.yaml"); }), HasSubstr("f.yaml:1:1: ")) << text;
  }
}

TEST(YamlMapErrors, SurviveAnyBytes) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = "number: 1\n" + std::string(1, static_cast<char>(byte)) + ": 2\n";
    try {
      read_all(text);
    } catch (const InputError&) {
    }
  }
}

TEST(YamlMapErrors, AMissingKeyIsReportedAtTheMap) {
  YamlMap yaml = YamlMap::from_text("\nother: 1", "f.yaml");
  EXPECT_EQ(thrown_message([&] { yaml.number("resolution", kPositive); }), "f.yaml:2:1: missing key 'resolution'");
  EXPECT_EQ(thrown_message([&] { yaml.integer("count", 0, 1); }), "f.yaml:2:1: missing key 'count'");
  EXPECT_EQ(thrown_message([&] { yaml.text("name"); }), "f.yaml:2:1: missing key 'name'");
  EXPECT_EQ(thrown_message([&] { yaml.path("image"); }), "f.yaml:2:1: missing key 'image'");
  EXPECT_EQ(thrown_message([&] { yaml.numbers("origin", 3, kFinite); }), "f.yaml:2:1: missing key 'origin'");
  EXPECT_EQ(thrown_message([&] { yaml.map("robot"); }), "f.yaml:2:1: missing key 'robot'");
}

TEST(YamlMapErrors, AMisspeltKeyIsReportedInPlaceOfTheMissingOne) {
  YamlMap yaml = YamlMap::from_text("image: a\nresoluton: 1", "f.yaml");
  EXPECT_EQ(thrown_message([&] { yaml.number("resolution", kPositive); }),
            "f.yaml:2:1: unknown key 'resoluton' (did you mean 'resolution'?)");
}

TEST(YamlMapErrors, AGoodKeyYetToBeReadIsNotTakenForTheMissingOne) {
  YamlMap yaml = YamlMap::from_text("max: 10\ncount: 32", "sensor.yaml");
  EXPECT_EQ(thrown_message([&] { yaml.number("min", kFinite); }), "sensor.yaml:1:1: missing key 'min'");
}

TEST(YamlMapErrors, FailPointsAtTheValueOrElseAtTheMap) {
  const YamlMap yaml = YamlMap::from_text("a: 1\nb: [1]", "f.yaml");
  EXPECT_EQ(thrown_message([&] { yaml.fail("b", "no good"); }), "f.yaml:2:4: no good");
  EXPECT_EQ(thrown_message([&] { yaml.fail("c", "no good"); }), "f.yaml:1:1: no good");
}

TEST(YamlMapErrors, NameTheFileThatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(thrown_message([&] { YamlMap::from_file(folder / "none.yaml"); }), (folder / "none.yaml").string() + ": no such file");
  EXPECT_EQ(thrown_message([&] { YamlMap::from_file(folder / "."); }), (folder / ".").string() + ": not a regular file");
  const auto huge = folder.write("huge.yaml", "");
  std::filesystem::resize_file(huge, YamlMap::kLargestFile + 1);
  EXPECT_THAT(thrown_message([&] { YamlMap::from_file(huge); }), HasSubstr("at most 16777216 are read"));
}

}  // namespace
}  // namespace alignability
