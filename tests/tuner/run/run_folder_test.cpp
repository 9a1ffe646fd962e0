#include "tuner/run/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/sim/support/files.hpp"
#include "tuner/run/append_file.hpp"

namespace armtune {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(RunFolder, IsMadeWithItsParentsAndBelongsToOneRunAtATime) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "runs/first";
  std::optional<FolderLock> lock = make_run_folder(path);
  EXPECT_TRUE(fs::is_directory(path));
  EXPECT_THAT(test::refusal([&] { (void)make_run_folder(path); }),
              testing::AllOf(HasSubstr(path), HasSubstr("another run is about to write into it"),
                             HasSubstr("--out")));
  lock.reset();
  const FolderLock next = make_run_folder(path);  // the first has left nothing
  EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 0) << "a lock is no file";
}

TEST(RunFolder, ALockThatIsMovedIsHeldOnce) {
  const test::TemporaryFolder folder;
  FolderLock lock;
  lock = make_run_folder(folder / "run");
  EXPECT_THAT(test::refusal([&] { (void)make_run_folder(folder / "run"); }), HasSubstr("another run"));
  lock = FolderLock();
  EXPECT_NO_THROW((void)make_run_folder(folder / "run"));
}

TEST(RunFolder, NoNameIsNoFolder) {
  EXPECT_NO_THROW((void)make_run_folder(""));
}

TEST(RunFolder, WhatAnotherRunHasLeftIsRefused) {
  const test::TemporaryFolder folder;
  folder.write("kept.txt", "precious\n");
  EXPECT_THAT(test::refusal([&] { (void)make_run_folder(folder.path()); }), HasSubstr("not empty"));
  EXPECT_EQ(test::read_text(folder / "kept.txt"), "precious\n");
}

TEST(AppendFile, SaysAtOnceThatItsFileIsGone) {
  const test::TemporaryFolder folder;
  AppendFile file(folder / "journal.txt");
  file.append("one\n");
  fs::remove(folder / "journal.txt");
  try {
    file.append("two\n");
    ADD_FAILURE() << "went on writing where nobody can read";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), testing::AllOf(HasSubstr(folder / "journal.txt"), HasSubstr("was deleted")));
  }
}

}  // namespace
}  // namespace armtune
