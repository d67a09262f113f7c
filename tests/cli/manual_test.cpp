// SPDX-License-Identifier: BSD-3-Clause
// Man pages and completions, held against the command line itself and tried in the shells that read them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <sstream>

#include "cli/command_line.hpp"
#include "cli/completion.hpp"
#include "cli/man_page.hpp"
#include "tests/core/temporary_folder.hpp"

namespace alignability::cli {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

// What a command of the shell says on both streams.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string output;
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, pipe.get())) output.append(part, count);
  return output;
}

bool is_installed(const std::string& program) { return !output_of("command -v " + program).empty(); }

std::string without(std::string text, const std::string& part, const std::string& instead) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + instead.size())) {
    text.replace(at, part.size(), instead);
  }
  return text;
}

std::string utf8(unsigned long code) {
  const auto tail = [code](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x800) return {static_cast<char>(0xc0 | code >> 6), tail(0)};
  return {static_cast<char>(0xe0 | code >> 12), tail(6), tail(0)};
}

// What a page of roff says, without how.
std::string read_roff(std::string page) {
  const std::string code = "\\[u";
  for (std::size_t at = page.find(code); at != std::string::npos; at = page.find(code)) {
    const std::size_t end = page.find(']', at);
    page.replace(at, end + 1 - at, utf8(std::stoul(page.substr(at + code.size(), end - at - code.size()), nullptr, 16)));
  }
  for (const auto& [escape, meant] : {std::pair{"\\-", "-"},
                                      {"\\fB", ""},
                                      {"\\fI", ""},
                                      {"\\fR", ""},
                                      {"\\&", ""},
                                      {"\\(aq", "'"},
                                      {"\\(dq", "\""},
                                      {"\\(ti", "~"},
                                      {"\\(rs", "\\"}}) {
    page = without(std::move(page), escape, meant);
  }
  return page;
}

class Manual : public testing::Test {
 protected:
  // "alignability plan" of a command.
  static std::string words_of(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : words_of(*parent) + ' ' + command.get_name();
  }
  static std::vector<const CLI::App*> all_beneath(const CLI::App& command) {
    std::vector<const CLI::App*> all{&command};
    for (const CLI::App* beneath : command.get_subcommands({})) {
      for (const CLI::App* each : all_beneath(*beneath)) all.push_back(each);
    }
    return all;
  }
  static std::set<std::string> options_of(const CLI::App& command) {
    std::set<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_snames()) names.insert('-' + name);
      for (const std::string& name : option->get_lnames()) names.insert("--" + name);
    }
    return names;
  }
  std::vector<const CLI::App*> all() const { return all_beneath(*app_); }

  test::TemporaryFolder folder_;
  Work work_;
  std::unique_ptr<CLI::App> app_ = command_line(work_, "");
  CommandReference program_ = reference_of(*app_);
};

class ManPages : public Manual {};

TEST_F(ManPages, TellOfEveryCommandAndOption) {
  const std::vector<const CommandReference*> pages = flattened(program_);
  ASSERT_EQ(pages.size(), all().size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const CLI::App& command = *all()[i];
    const std::string page = read_roff(man_page(*pages[i], program_, "0"));
    EXPECT_EQ(man_page_name(*pages[i]), without(words_of(command), " ", "-"));
    EXPECT_THAT(page, HasSubstr('\n' + command.get_description())) << words_of(command);
    for (const std::string& option : options_of(command)) EXPECT_THAT(page, HasSubstr(option)) << words_of(command);
    for (const CLI::Option* option : command.get_options()) EXPECT_THAT(page, HasSubstr(option->get_description())) << words_of(command);
    for (const CLI::App* beneath : command.get_subcommands({})) EXPECT_THAT(page, HasSubstr("\n" + beneath->get_name() + "\n"));
  }
}

TEST_F(ManPages, HaveTheSectionsThatReadersLookFor) {
  for (const CommandReference* command : flattened(program_)) {
    const std::string page = man_page(*command, program_, "1.2.3");
    for (const std::string section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "SEE ALSO"}) {
      EXPECT_THAT(page, HasSubstr("\n.SH " + section + '\n')) << command->words.back();
    }
    EXPECT_EQ(page.find("\n.SH EXAMPLES\n") != std::string::npos, command != &program_) << command->words.back();
    EXPECT_THAT(page, HasSubstr("\"alignability 1.2.3\""));
  }
}

TEST_F(ManPages, AreReadByGroffWithoutAWarning) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  for (const CommandReference* command : flattened(program_)) {
    const auto page = folder_.write(man_page_name(*command) + ".1", man_page(*command, program_, "1.2.3"));
    EXPECT_EQ(output_of("groff -man -Tutf8 -ww -z '" + page.string() + "'"), "") << page.filename();
  }
}

TEST_F(ManPages, AreOfAsciiAlone) {
  for (const CommandReference* command : flattened(program_)) {
    for (const char c : man_page(*command, program_, "0")) ASSERT_GT(c, 0) << command->words.back();
  }
}

class BashCompletion : public Manual {
 protected:
  // What bash offers for the last of these words.
  std::set<std::string> offered(const std::string& words) {
    folder_.write("alignability.bash", bash_completion(program_));
    const auto script =
        folder_.write("offer.bash", "cd '" + (folder_ / "").string() + "'\n. ./alignability.bash\nset -u\nCOMP_WORDS=(" + words +
                                        ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_alignability\n"
                                        "((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"\n");
    return lines_of(output_of("bash --norc '" + script.string() + "'"));
  }
};

TEST_F(BashCompletion, OffersEveryCommandAndOption) {
  for (const CLI::App* command : all()) {
    EXPECT_EQ(offered(words_of(*command) + " -"), options_of(*command)) << words_of(*command);
    if (command->get_subcommands({}).empty()) continue;
    std::set<std::string> names;
    for (const CLI::App* beneath : command->get_subcommands({})) names.insert(beneath->get_name());
    EXPECT_EQ(offered(words_of(*command) + " ''"), names) << words_of(*command);
  }
}

TEST_F(BashCompletion, CompletesCommandsAndOptions) {
  EXPECT_THAT(offered("alignability pl"), ElementsAre("plan"));
  EXPECT_THAT(offered("alignability plan --pl"), ElementsAre("--planner"));
  EXPECT_THAT(offered("alignability validate p"), ElementsAre("path"));
  EXPECT_THAT(offered("alignability validate path --dr"), ElementsAre("--drive-file", "--drive-seed"));
}

TEST_F(BashCompletion, CompletesWordsOfWhichThereAreFew) {
  EXPECT_THAT(offered("alignability map --engine n"), ElementsAre("native"));
  EXPECT_THAT(offered("alignability map --engine = n"), ElementsAre("native"));
  EXPECT_THAT(offered("alignability map --engine ="), ElementsAre("native", "pcl"));
  EXPECT_THAT(offered("alignability map --up ''"), ElementsAre("x", "y", "z"));
  EXPECT_THAT(offered("alignability plan --planner bitst"), ElementsAre("bitstar"));
  EXPECT_THAT(offered("alignability compare --localizer scan"), ElementsAre("scan_matching"));
  EXPECT_THAT(offered("alignability completion f"), ElementsAre("fish"));
}

TEST_F(BashCompletion, CompletesTheLastWordOfAListApartByCommas) {
  EXPECT_THAT(offered("alignability map --readings r"), ElementsAre("robust"));
  EXPECT_THAT(offered("alignability map --readings robust,v"), ElementsAre("robust,voxel"));
  EXPECT_THAT(offered("alignability plan --pictures svg,pd"), ElementsAre("svg,pdf"));
}

TEST_F(BashCompletion, OffersFilesOfTheKindThatIsWanted) {
  for (const char* name : {"a map.yaml", "b.yml", "c.csv", "d.pcd"}) folder_.write(name, "");
  std::filesystem::create_directories(folder_ / "maps");
  EXPECT_THAT(offered("alignability plan --map ''"), ElementsAre("a map.yaml", "b.yml", "maps"));
  EXPECT_THAT(offered("alignability plan ''"), ElementsAre("a map.yaml", "b.yml", "maps"));
  EXPECT_THAT(offered("alignability validate path x.yaml ''"), IsSupersetOf({"a map.yaml", "b.yml", "c.csv", "maps"}));
  EXPECT_THAT(offered("alignability score ''"), IsSupersetOf({"a map.yaml", "c.csv", "d.pcd", "maps"}));
  EXPECT_THAT(offered("alignability map --merge a.yaml ''"), ElementsAre("a map.yaml", "b.yml", "maps"));
  EXPECT_THAT(offered("alignability map --model-path ''"), ElementsAre("maps"));
}

TEST_F(BashCompletion, OffersNothingForNumbersAndTakesTheirSignForNoOption) {
  folder_.write("world.sdf", "");
  EXPECT_THAT(offered("alignability plan --weight ''"), ElementsAre());
  EXPECT_THAT(offered("alignability occupancy --z-min -1 w"), ElementsAre("world.sdf"));
}

class FishCompletion : public Manual {
 protected:
  void SetUp() override {
    if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  }
  // What fish offers for the last word of a line, without descriptions.
  std::set<std::string> offered(const std::string& line) {
    const std::string home = (folder_ / "").string();
    const auto script = folder_.write("alignability.fish", fish_completion(program_));
    const auto asked = folder_.write("ask.fish", "cd '" + home + "'\nsource '" + script.string() + "'\ncomplete -C '" + line + "'\n");
    std::set<std::string> words;
    for (const std::string& found : lines_of(output_of("HOME='" + home + "' fish --no-config '" + asked.string() + "'"))) {
      words.insert(found.substr(0, found.find('\t')));
    }
    return words;
  }
};

TEST_F(FishCompletion, OffersEveryCommandAndOption) {
  for (const CLI::App* command : all()) {
    std::set<std::string> names;
    for (const std::string& name : options_of(*command)) {
      if (name.starts_with("--")) names.insert(name);
    }
    EXPECT_EQ(offered(words_of(*command) + " --"), names) << words_of(*command);
    for (const CLI::App* beneath : command->get_subcommands({})) {
      EXPECT_THAT(offered(words_of(*command) + ' '), Contains(beneath->get_name()));
    }
  }
}

TEST_F(FishCompletion, CompletesWordsListsAndFiles) {
  folder_.write("site.yaml", "");
  EXPECT_THAT(offered("alignability pl"), ElementsAre("plan"));
  EXPECT_THAT(offered("alignability map --engine n"), ElementsAre("native"));
  EXPECT_THAT(offered("alignability map --readings robust,v"), ElementsAre("robust,voxel"));
  EXPECT_THAT(offered("alignability plan --map s"), ElementsAre("site.yaml"));
  EXPECT_THAT(offered("alignability plan s"), ElementsAre("site.yaml"));
}

class ZshCompletion : public Manual {
 protected:
  void SetUp() override {
    if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  }
  // The line that an interactive zsh has after Tab.
  std::string completed(const std::string& line) {
    folder_.write("_alignability", zsh_completion(program_));
    const std::string inner =
        "cd '" + (folder_ / "").string() +
        "'; PROMPT=; autoload -U compinit; compinit -D -u; source ./_alignability; "
        "tell() { print -r -- \"$BUFFER\" > told.part; mv told.part told; BUFFER=; }; zle -N tell; bindkey '^X' tell; print is''ready\n";
    folder_.write("inner", inner);
    folder_.write("line", line);
    const auto script = folder_.write("outer.zsh",
                                      "cd ${0:h}\nzmodload zsh/zpty\nzpty shell zsh -f -i\nzpty -w -n shell \"$(<inner)\"$'\\n'\n"
                                      "zpty -r shell output '*isready*'\nzpty -w -n shell \"$(<line)\"$'\\t\\x18'\n"
                                      "repeat 600; do [[ -e told ]] && break; sleep 0.1; done\ncat told\nzpty -d shell\n");
    std::filesystem::remove(folder_ / "told");
    return output_of("zsh -f '" + script.string() + "'");
  }
};

TEST_F(ZshCompletion, CompletesCommandsOptionsWordsAndFiles) {
  folder_.write("site.yaml", "");
  folder_.write("site.csv", "");
  EXPECT_EQ(completed("alignability pl"), "alignability plan \n");
  EXPECT_EQ(completed("alignability plan --pl"), "alignability plan --planner=\n");
  EXPECT_EQ(completed("alignability validate pa"), "alignability validate path \n");
  EXPECT_EQ(completed("alignability map --engine n"), "alignability map --engine native \n");
  // A space typed after it takes the comma back.
  EXPECT_EQ(completed("alignability plan --pictures svg,pd"), "alignability plan --pictures svg,pdf,\n");
  EXPECT_EQ(completed("alignability plan si"), "alignability plan site.yaml \n");
}

TEST_F(ZshCompletion, KnowsEveryCommandAndOption) {
  const std::string script = zsh_completion(program_);
  for (const CLI::App* command : all()) {
    const std::size_t begin = script.find('_' + without(words_of(*command), " ", "_") + "() {\n");
    ASSERT_NE(begin, std::string::npos) << words_of(*command);
    const std::string function = script.substr(begin, script.find("\n}\n", begin) - begin);
    for (const std::string& option : options_of(*command)) {
      EXPECT_THAT(function, AnyOf(HasSubstr('\'' + option), HasSubstr(')' + option), HasSubstr(")'" + option))) << words_of(*command);
    }
    for (const CLI::App* beneath : command->get_subcommands({})) EXPECT_THAT(function, HasSubstr('\'' + beneath->get_name() + ':'));
  }
}

}  // namespace
}  // namespace alignability::cli
