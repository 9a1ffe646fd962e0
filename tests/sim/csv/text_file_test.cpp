#include "sim/csv/text_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "core/common/path_state.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace text_file_test {

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
  fs::create_directory(partial_path(path));  // stands where the new file would be written
  EXPECT_THAT([&] { write_text_file(path, "new\n"); }, test::refused_at({.file = partial_path(path)}));
  EXPECT_EQ(test::read_text(path), "old\n");
}

TEST(TextFile, AFolderThatIsNotThereIsNamedAsTheUserNamedIt) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  for (const std::string& parent : {folder / "none", file}) {
    for (const auto write : {write_text_file, write_new_text_file}) {
      const std::string why = test::refusal([&] { write(parent + "/x.html", "text"); });
      EXPECT_THAT(why, HasSubstr(parent + "/x.html: "));
      EXPECT_THAT(why, HasSubstr("there is no folder " + parent));
      EXPECT_THAT(why, testing::Not(HasSubstr("partial")));
    }
  }
}

TEST(TextFile, AFolderInTheWayStaysAndIsNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  fs::create_directory(path);
  EXPECT_THAT([&] { write_text_file(path, "new\n"); }, test::refused_at({.file = path}));
  EXPECT_TRUE(fs::is_directory(path));
  EXPECT_FALSE(fs::exists(partial_path(path))) << "what could not be put in place is taken away";
}

TEST(TextFile, AUsersOwnFileIsNeitherReplacedNorTakenForArmtunes) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "mine\n");
  const std::string beside = folder.write("b.csv.partial", "mine too\n");
  fs::create_symlink(folder / "nowhere", folder / "link.csv");
  for (const std::string& taken : {path, folder / "link.csv"}) {
    EXPECT_THAT([&] { write_new_text_file(taken, "new\n"); }, test::refused_at({.file = taken}));
    EXPECT_THAT([&] { refuse_existing(taken); }, test::refused_at({.file = taken}));
  }
  EXPECT_EQ(test::read_text(path), "mine\n");
  write_new_text_file(folder / "b.csv", "new\n");
  EXPECT_EQ(test::read_text(folder / "b.csv"), "new\n");
  EXPECT_EQ(test::read_text(beside), "mine too\n");
  EXPECT_FALSE(fs::exists(partial_path(folder / "b.csv")));
}

TEST(TextFile, AFolderThatMayNotBeWrittenToIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "this user writes everywhere";
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old\n");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT([&] { write_text_file(path, "new\n"); }, test::refused_at({.file = path}));
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(test::read_text(path), "old\n");
}

/// Permissions of a file [octal].
unsigned mode(const std::string& path) {
  return static_cast<unsigned>(fs::symlink_status(path).permissions());
}

TEST(PrivateTextFile, IsNotWrittenThroughALinkThatSomebodyPutThere) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old\n");
  const std::string victim = folder.write("victim", "precious\n");
  for (const bool symbolic : {true, false}) {
    if (symbolic) {
      fs::create_symlink(victim, partial_path(path));
    } else {
      fs::create_hard_link(victim, partial_path(path));
    }
    write_text_file(path, "new\n");
    EXPECT_EQ(test::read_text(victim), "precious\n") << (symbolic ? "symbolic" : "hard") << " link";
    EXPECT_EQ(test::read_text(path), "new\n");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path)));
    EXPECT_EQ(fs::hard_link_count(path), 1U);
    EXPECT_FALSE(fs::exists(fs::symlink_status(partial_path(path))));
  }
}

TEST(PrivateTextFile, DoesNotWaitForAPipeNorMakeWhatADanglingLinkNames) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  ASSERT_EQ(::mkfifo(partial_path(path).c_str(), 0666), 0);
  write_text_file(path, "new\n");  // opening the pipe would never end
  EXPECT_EQ(test::read_text(path), "new\n");
  fs::create_symlink(folder / "made", partial_path(path));
  write_text_file(path, "newer\n");
  EXPECT_FALSE(fs::exists(folder / "made"));
  EXPECT_EQ(test::read_text(path), "newer\n");
}

TEST(PrivateTextFile, HasTheUsersOwnPermissionsWhileItGrowsAndAfter) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  for (const auto& [mask, expected] : {std::pair{0077U, 0600U}, std::pair{0000U, 0644U}}) {
    const std::string planted = folder.write("a.csv.armtune.partial", "");  // open to everybody
    fs::permissions(planted, fs::perms::all);
    const mode_t before = ::umask(mask);
    const int growing = make_partial_file(path);
    const unsigned meanwhile = mode(planted);
    ::close(growing);
    write_text_file(path, "new\n");
    ::umask(before);
    EXPECT_GE(growing, 0);
    EXPECT_EQ(meanwhile, expected) << "nobody else may write to it";
    EXPECT_EQ(mode(path), expected);
  }
}

TEST(PrivateTextFile, ThatGrowsRowByRowIsNotWrittenThroughALinkEither) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  const std::string victim = folder.write("victim", "precious\n");
  fs::create_symlink(victim, partial_path(path));
  const int growing = make_partial_file(path, O_APPEND);
  ASSERT_GE(growing, 0);
  EXPECT_NE(::fcntl(growing, F_GETFL) & O_APPEND, 0);
  EXPECT_NE(::fcntl(growing, F_GETFD) & FD_CLOEXEC, 0) << "no program that is started inherits it";
  EXPECT_EQ(::write(growing, "x", 1), 1);
  ::close(growing);
  EXPECT_EQ(test::read_text(victim), "precious\n");
}

TEST(MakeFolder, MakesParentsAndTakesOneThatIsThere) {
  const test::TemporaryFolder folder;
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  EXPECT_NO_THROW(make_folder(folder / "a/b"));
  folder.write("file", "");
  EXPECT_THAT([&] { make_folder(folder / "file"); }, test::refused_at({.file = folder / "file"}));
}

}  // namespace text_file_test
}  // namespace armtune::internal
