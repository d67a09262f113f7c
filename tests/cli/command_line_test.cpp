// SPDX-License-Identifier: BSD-3-Clause
// What the program says of a wrong command line, and of files that are not there or wrong: exit code 2, and nothing on stdout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/cli/small_site.hpp"

namespace alignability {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

struct Fault {
  const char* arguments;
  const char* message;
};

class CommandLine : public testing::TestWithParam<Fault> {};

TEST_P(CommandLine, IsRefusedWithExitCodeTwo) {
  const test::TemporaryFolder folder;
  test::write_small_site(folder);
  const test::Outcome outcome = test::run_program(words_of(GetParam().arguments), folder / "");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.substr(0, outcome.err.find('\n')), GetParam().message);
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(
    Word, CommandLine,
    testing::Values(Fault{"", "alignability: A subcommand is required"},
                    Fault{"plam a.yaml", "alignability: unknown command 'plam' (did you mean 'plan'?)"},
                    Fault{"--vresion", "alignability: unknown option '--vresion' (did you mean '--version'?)"},
                    Fault{"plan a.yaml --wieght 3", "alignability: unknown option '--wieght' (did you mean '--weight'?)"},
                    Fault{"plan a.yaml --wieght=3", "alignability: unknown option '--wieght' (did you mean '--weight'?)"},
                    Fault{"occupancy a.sdf --zmin 0 --z-max 2 -o x", "alignability: unknown option '--zmin' (did you mean '--z-min'?)"},
                    Fault{"score a.pcd -p x.png", "alignability: unknown option '-p'"},
                    Fault{"score a.pcd --frobnicate", "alignability: unknown option '--frobnicate'"},
                    Fault{"plan a.yaml b.yaml", "alignability: The following argument was not expected: b.yaml"},
                    Fault{"plan", "alignability: problem is required"},
                    Fault{"occupancy a.sdf --z-min 0 --z-max 2", "alignability: --output is required"},
                    Fault{"plan a.yaml --time 1 --iterations 5", "alignability: --time excludes --iterations"},
                    Fault{"plan a.yaml --weight 1 --weight 2", "alignability: --weight: At Most 1 required but received 2"}));

INSTANTIATE_TEST_SUITE_P(
    Value, CommandLine,
    testing::Values(
        Fault{"plan a.yaml --weight -3", "alignability: --weight: must be at least 0, not -3"},
        Fault{"plan a.yaml --weight heavy", "alignability: --weight: must be at least 0, not heavy"},
        Fault{"plan a.yaml --time 0", "alignability: --time: must be greater than 0, not 0"},
        Fault{"plan a.yaml --time nan", "alignability: --time: must be greater than 0, not nan"},
        Fault{"plan a.yaml --seed 0", "alignability: --seed: Value 0 not in range 1 to 4294967295"},
        Fault{"plan a.yaml --seed 1.5", "alignability: --seed: must be a whole number, not 1.5"},
        Fault{"plan a.yaml --start 1,2", "alignability: --start: At least 3 required but received 2"},
        Fault{"plan a.yaml --start 1,two,3", "alignability: --start: must be a finite number, not two"},
        Fault{"plan a.yaml --goal 1,2,nan", "alignability: --goal: must be a finite number, not nan"},
        Fault{"occupancy a.sdf --z-min nan --z-max 1 -o x", "alignability: --z-min: must be a finite number, not nan"},
        Fault{"occupancy a.sdf --z-min 0 --z-max inf -o x", "alignability: --z-max: must be a finite number, not inf"},
        Fault{"occupancy a.sdf --z-min 0 --z-max 1 -o x --resolution 0", "alignability: --resolution: must be greater than 0, not 0"},
        Fault{"occupancy a.sdf --z-min 2 --z-max 1 -o x", "alignability: --z-min must be less than --z-max"},
        Fault{"occupancy a.sdf --z-min 0 --z-max 1 -o x --geometry visul",
              "alignability: --geometry: must be visual or collision, not visul (did you mean 'visual'?)"},
        Fault{"map --scene a --occupancy b --sensor c -o x --samples 0", "alignability: --samples: Value 0 not in range 1 to 100000"},
        Fault{"map --scene a --occupancy b --sensor c -o x --threads -1",
              "alignability: --threads: must be a whole number of at least 0, not -1"},
        Fault{"map --scene a --occupancy b --sensor c -o x --seed -1", "alignability: --seed: must be a whole number, not -1"},
        Fault{"map --scene a --occupancy b --sensor c -o x --engine pl", "alignability: --engine: pl not in {native,pcl}"},
        Fault{"map --scene a --occupancy b --sensor c -o x --stride 5", "alignability: --stride: Value 5 not in range 1 to 4"},
        Fault{"map --scene a --occupancy b --sensor c -o x --readings robust,sturdy",
              "alignability: --readings: sturdy not in {centred,voxel,robust,information}"},
        Fault{"scan --scene a --sensor b -o x --at 1,2,0 --floor nan", "alignability: --floor: must be a finite number, not nan"},
        Fault{"plan a.yaml -o b --pictures jpg", "alignability: --pictures: jpg not in {png,svg,pdf}"},
        Fault{"plan a.yaml --pictures svg", "alignability: --pictures requires --output"},
        Fault{"score a.pcd b.pcd --picture x.png", "alignability: --picture draws one scan; give one"}));

INSTANTIATE_TEST_SUITE_P(
    File, CommandLine,
    testing::Values(
        Fault{"plan missing.yaml", "missing.yaml: no such file"}, Fault{"compare missing.yaml", "missing.yaml: no such file"},
        Fault{"plan problem.yaml", "occupancy.yaml: no such file"},
        Fault{"plan problem.yaml --map missing.yaml", "missing.yaml: no such file"},
        Fault{"score missing.pcd", "missing.pcd: no such file"},
        Fault{"score sensor.yaml", "sensor.yaml: is neither a PCD nor a PLY file, nor has it the extension .bin"},
        Fault{"scan --scene missing.sdf --sensor sensor.yaml --at 1,1,0 -o x", "missing.sdf: no such file"},
        Fault{"scan --scene world.sdf --sensor missing.yaml --at 1,1,0 -o x", "missing.yaml: no such file"},
        Fault{"scan --scene world.sdf --sensor sensor.yaml --at 1,1,0 -o no/x.pcd",
              "no/x.pcd: cannot be written: No such file or directory"},
        Fault{"occupancy missing.sdf --z-min 0 --z-max 1 -o x", "missing.sdf: no such file"},
        Fault{"occupancy world.sdf --z-min 0 --z-max 1 -o x --model-path no", "alignability: --model-path: Directory does not exist: no"},
        Fault{"occupancy world.sdf --z-min 50 --z-max 51 -o x", "world.sdf: has nothing between --z-min and --z-max"},
        Fault{"occupancy problem.yaml --z-min 0 --z-max 1 -o x",
              "problem.yaml: is no site that is known: a world (SDF), a mesh (DAE, STL, OBJ, PLY, glTF) or a point cloud (PCD, PLY, BIN)"},
        Fault{"map --scene world.sdf --occupancy missing.yaml --sensor sensor.yaml -o x", "missing.yaml: no such file"},
        Fault{"map --scene world.sdf --occupancy sensor.yaml --sensor sensor.yaml -o x", "sensor.yaml:1:1: missing key 'image'"}));

INSTANTIATE_TEST_SUITE_P(
    Explain, CommandLine,
    testing::Values(Fault{"explain 1,1", "alignability: --scene is required, or a --problem that names one"},
                    Fault{"explain 1,1 --scene world.sdf", "alignability: --sensor is required, or a --problem that names one"},
                    Fault{"explain 1,1 --problem problem.yaml", "problem.yaml: names no 'scene'; give --scene"},
                    Fault{"explain 1 --scene world.sdf --sensor sensor.yaml", "alignability: place: At least 2 required but received 1"},
                    Fault{"explain 1,nan --scene world.sdf --sensor sensor.yaml", "alignability: place: must be a finite number, not nan"},
                    Fault{"explain 1,1 --scene missing.sdf --sensor sensor.yaml", "missing.sdf: no such file"},
                    Fault{"explain 4,3 --scene world.sdf --sensor sensor.yaml",
                          "world.sdf: at 4, 3 the sensor would be in a surface or within 0.1 m of one"},
                    Fault{"explain 40,-3 --scene world.sdf --sensor sensor.yaml",
                          "world.sdf: the place 40, -3 lies off it; it goes from -0.2, -0.2 to 8.2, 6.2"}));

// Each run in a folder of its own: ctest runs these tests side by side.
test::Outcome run(const std::vector<std::string>& arguments) {
  const test::TemporaryFolder folder;
  return test::run_program(arguments, folder / "");
}

// The options of a command that take a value, and their types, as its help lists them: "  -o,--output TEXT REQUIRED   NAME: …".
std::vector<std::pair<std::string, std::string>> options_with_values(const std::string& command) {
  std::vector<std::pair<std::string, std::string>> options;
  std::istringstream help(run({command, "--help"}).out);
  for (std::string line; std::getline(help, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() < 2 || words[0][0] != '-' || words[0].find("--") == std::string::npos) continue;
    const std::string type = words[1].substr(0, words[1].find_first_of(":=,[]"));
    const bool is_type = type.size() > 2 && type.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
    if (is_type) options.emplace_back(words[0].substr(words[0].find("--")), type);
  }
  return options;
}

class EveryOption : public testing::TestWithParam<const char*> {};

TEST_P(EveryOption, OfNumbersRefusesNanAndAllRefuseToLackTheirValue) {
  const auto options = options_with_values(GetParam());
  ASSERT_FALSE(options.empty());
  const auto fault = [&](const std::vector<std::string>& arguments) {
    const test::Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments[1];
    return outcome.err;
  };
  const std::string first = options.front().first;
  EXPECT_THAT(fault({GetParam(), first + "x", "1"}), HasSubstr("(did you mean '" + first + "'?)"));
  for (const auto& [option, type] : options) {
    EXPECT_THAT(fault({GetParam(), option}), StartsWith("alignability: " + option));
    if (type != "FLOAT" && type != "INT" && type != "UINT") continue;
    EXPECT_THAT(fault({GetParam(), option, "nan"}), AllOf(StartsWith("alignability: " + option + ": must be "), HasSubstr("nan")));
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryOption,
                         testing::Values("occupancy", "scan", "sample", "score", "map", "plan", "compare", "explain", "evaluate", "export"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace alignability
