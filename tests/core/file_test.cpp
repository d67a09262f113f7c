// SPDX-License-Identifier: BSD-3-Clause
#include "core/file.hpp"

#include <gmock/gmock.h>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

using test::TemporaryFolder;
using test::thrown_message;
using ::testing::StartsWith;

constexpr std::uintmax_t kPlenty = 1 << 20;

TEST(ReadFile, GivesTheBytesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string bytes("a\r\n\0\xff z", 7);
  EXPECT_EQ(read_file(folder.write("bytes", bytes), kPlenty), bytes);
  EXPECT_EQ(read_file(folder.write("empty", ""), kPlenty), "");
}

TEST(ReadFile, RefusesAFileThatIsTooLong) {
  const TemporaryFolder folder;
  const auto file = folder.write("five", "12345");
  EXPECT_EQ(read_file(file, 5), "12345");
  EXPECT_EQ(thrown_message([&] { read_file(file, 4); }), file.string() + ": is 5 bytes long; at most 4 are read");
}

TEST(ReadFile, NamesWhatIsNotThere) {
  const TemporaryFolder folder;
  const auto missing = folder / "missing.yaml";
  EXPECT_EQ(thrown_message([&] { read_file(missing, kPlenty); }), missing.string() + ": no such file");
  EXPECT_EQ(thrown_message([&] { read_file(missing / "deeper", kPlenty); }), (missing / "deeper").string() + ": no such file");
}

TEST(ReadFile, RefusesAFolderAndADevice) {
  const TemporaryFolder folder;
  EXPECT_EQ(thrown_message([&] { read_file(folder / "", kPlenty); }), (folder / "").string() + ": not a regular file");
  EXPECT_EQ(thrown_message([&] { read_file("/dev/zero", kPlenty); }), "/dev/zero: not a regular file");
}

TEST(AtomicFile, IsThereOnlyFromTheCommitOn) {
  const TemporaryFolder folder;
  const auto target = folder / "result.csv";
  {
    AtomicFile file(target);
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(std::filesystem::exists(target));
    file.commit();
    EXPECT_EQ(read_file(target, kPlenty), "one two");
  }
  EXPECT_EQ(folder.files(), 1);
}

TEST(AtomicFile, LeavesTheOldFileWithoutACommit) {
  const TemporaryFolder folder;
  const auto target = folder.write("result.csv", "old");
  {
    AtomicFile file(target);
    file.write("new, but never finished");
    EXPECT_EQ(read_file(target, kPlenty), "old");
    EXPECT_EQ(folder.files(), 2);
  }
  EXPECT_EQ(read_file(target, kPlenty), "old");
  EXPECT_EQ(folder.files(), 1) << "the temporary is left behind";
}

TEST(AtomicFile, ReplacesTheOldFileAtTheCommit) {
  const TemporaryFolder folder;
  const auto target = folder.write("result.csv", "old and longer");
  write_file(target, "new");
  EXPECT_EQ(read_file(target, kPlenty), "new");
  EXPECT_EQ(folder.files(), 1);
}

TEST(AtomicFile, IsWrittenBesideItsPlace) {
  const TemporaryFolder folder;
  const AtomicFile file(folder / "result.csv");
  EXPECT_EQ(file.temporary().parent_path(), (folder / "result.csv").parent_path());
  EXPECT_TRUE(std::filesystem::exists(file.temporary()));
}

TEST(AtomicFile, MayBeOpenTwiceForOneTarget) {
  const TemporaryFolder folder;
  AtomicFile first(folder / "result.csv");
  AtomicFile second(folder / "result.csv");
  EXPECT_NE(first.temporary(), second.temporary());
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  EXPECT_EQ(read_file(folder / "result.csv", kPlenty), "first");
}

TEST(AtomicFile, TakesALargeWrite) {
  const TemporaryFolder folder;
  const std::string bytes(5 << 20, 'x');
  write_file(folder / "large", bytes);
  EXPECT_EQ(read_file(folder / "large", bytes.size()), bytes);
}

TEST(AtomicFile, NamesTheTargetWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  const auto target = folder / "missing" / "result.csv";
  EXPECT_EQ(thrown_message([&] { AtomicFile{target}; }), target.string() + ": cannot be written: No such file or directory");
}

TEST(AtomicFile, NamesTheTargetWhenItsTemporaryIsTakenAway) {
  const TemporaryFolder folder;
  const auto target = folder / "result.csv";
  AtomicFile file(target);
  std::filesystem::remove(file.temporary());
  const std::string told = target.string() + ": cannot be written: No such file or directory";
  EXPECT_EQ(thrown_message([&] { file.write("a"); }), told);
  EXPECT_EQ(thrown_message([&] { file.commit(); }), told);
}

TEST(AtomicFile, NamesTheTargetWhenTheFolderCannotBeWrittenTo) {
  const TemporaryFolder folder;
  const auto target = folder.write("file", "") / "result.csv";  // no permission bit stops root, a file for a folder does
  EXPECT_EQ(thrown_message([&] { write_file(target, "x"); }), target.string() + ": cannot be written: Not a directory");
}

TEST(AtomicFile, CannotReplaceAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  EXPECT_THAT(thrown_message([&] { write_file(folder / "taken", "x"); }),
              StartsWith((folder / "taken").string() + ": cannot be written: "));
  EXPECT_TRUE(std::filesystem::is_directory(folder / "taken"));
  EXPECT_EQ(folder.files(), 1) << "the temporary is left behind";
}

TEST(AtomicFile, NoticesThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const TemporaryFolder folder;
  AtomicFile file(folder / "result.csv");
  std::filesystem::remove(file.temporary());
  std::filesystem::create_symlink("/dev/full", file.temporary());
  EXPECT_EQ(thrown_message([&] { file.write("x"); }), (folder / "result.csv").string() + ": cannot be written: No space left on device");
}

TEST(AtomicFile, WritesANameWithoutAFolderIntoTheWorkingOne) {
  const std::filesystem::path name = "alignability-" + std::to_string(::getpid()) + ".tmp";
  write_file(name, "here");
  EXPECT_EQ(read_file(name, kPlenty), "here");
  std::filesystem::remove(name);
}

}  // namespace
}  // namespace alignability
