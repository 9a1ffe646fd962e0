#include "sim/csv/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/files.hpp"

namespace armtune {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(TextFile, ReplacesAFileWholeAndLeavesNothingBeside) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "a long old text\n");
  write_text_file(path, "new\n");
  EXPECT_EQ(test::read_text(path), "new\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  const std::string large(3'000'000, 'x');
  write_text_file(path, large);
  EXPECT_EQ(test::read_text(path), large);
}

TEST(TextFile, AFailureLeavesTheOldFileWhole) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old\n");
  fs::create_directory(path + ".partial");  // stands where the new file would be written
  EXPECT_THAT(test::refusal([&] { write_text_file(path, "new\n"); }), HasSubstr(path));
  EXPECT_EQ(test::read_text(path), "old\n");
}

TEST(TextFile, AFolderInTheWayStaysAndIsNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  fs::create_directory(path);
  EXPECT_THAT(test::refusal([&] { write_text_file(path, "new\n"); }), HasSubstr(path));
  EXPECT_TRUE(fs::is_directory(path));
  EXPECT_FALSE(fs::exists(path + ".partial")) << "what could not be put in place is taken away";
}

TEST(TextFile, AFolderThatMayNotBeWrittenToIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "this user writes everywhere";
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old\n");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(test::refusal([&] { write_text_file(path, "new\n"); }), HasSubstr(path));
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(test::read_text(path), "old\n");
}

TEST(MakeFolder, MakesParentsAndTakesOneThatIsThere) {
  const test::TemporaryFolder folder;
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  EXPECT_NO_THROW(make_folder(folder / "a/b"));
  folder.write("file", "");
  EXPECT_THAT(test::refusal([&] { make_folder(folder / "file"); }), HasSubstr(folder / "file"));
}

}  // namespace
}  // namespace armtune
