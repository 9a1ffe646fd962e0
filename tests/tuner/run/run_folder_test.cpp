#include "tuner/run/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "core/common/input_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/run/write_run_record.hpp"

namespace armtune::internal {
namespace run_folder_test {

namespace fs = std::filesystem;
using test::refused_at;
using testing::HasSubstr;

TEST(RunFolder, IsMadeWithItsParentsAndBelongsToOneRunAtATime) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "runs/first";
  std::optional<FolderLock> lock = make_run_folder(path);
  EXPECT_TRUE(fs::is_directory(path));
  const InputError second = test::input_error([&] { (void)make_run_folder(path); });
  EXPECT_THAT(second, refused_at({.file = path}));
  EXPECT_THAT(second.what(), HasSubstr("another run is about to write into"));
  lock.reset();
  const FolderLock next = make_run_folder(path);  // the first has left nothing
  EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 0) << "a lock is no file";
}

TEST(RunFolder, ALockThatIsMovedIsHeldOnce) {
  const test::TemporaryFolder folder;
  FolderLock lock;
  lock = make_run_folder(folder / "run");
  EXPECT_THAT([&] { (void)make_run_folder(folder / "run"); }, refused_at({.file = folder / "run"}));
  lock = FolderLock();
  EXPECT_NO_THROW((void)make_run_folder(folder / "run"));
}

TEST(RunFolder, NoNameIsNoFolder) {
  EXPECT_NO_THROW((void)make_run_folder(""));
}

TEST(RunFolder, WhatAnotherRunHasLeftIsRefused) {
  const test::TemporaryFolder folder;
  folder.write("kept.txt", "precious\n");
  EXPECT_THAT([&] { (void)make_run_folder(folder.path()); }, refused_at({.file = folder.path()}));
  EXPECT_EQ(test::read_text(folder / "kept.txt"), "precious\n");
}

TEST(RunFolder, APathThatLeavesNoRoomForFilesOrNoNameIsRefused) {
  const test::TemporaryFolder folder;
  std::string deep = folder.path();
  while (deep.size() < 3900) deep += "/" + std::string(200, 'd');
  for (const std::string& path : {deep, folder / "a\x1b[31m", folder / "caf\xE9"}) {
    EXPECT_THAT([&] { (void)make_run_folder(path); }, refused_at({.file = path}));
    EXPECT_FALSE(fs::exists(path));
  }
}

TEST(RunInputs, TellsOfAndKeepsTheBytesThatWereReadWhateverBecameOfTheFiles) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "a");
  fs::create_directories(folder / "b");
  fs::create_directories(folder / "run");
  const std::string odd = std::string(100, 'o') + "'s \xC3\xA9: #1.yaml";
  const std::vector<std::string> files = {folder.write("a/x.yaml", "first\n"),
                                          folder.write("b/x.yaml", "second"), folder.write(odd, "third\r\n")};
  const std::string log = folder.write("log.csv", "not kept\n");
  const std::string bundled = data_folder() + "/scenarios/moving_target.yaml";
  const std::vector<std::string> texts = {"first\n", "second", "third\r\n"};
  std::vector<std::string> hashes;
  for (const std::string& file : files) hashes.push_back(hash_of_file(file));

  const InputRecord record;
  for (const std::string& file : files) (void)read_input_file(file, 1000, "a text");
  for (const std::string& file : files) std::ofstream(file) << "edited";
  fs::remove(files[1]);
  write_run_record(folder / "run", {}, {{files[2], files[0], files[1], files[0], log, bundled}});

  const RunRecord run = find_run_record(folder / "run").value();
  EXPECT_EQ(run.inputs.size(), files.size() + 2) << "each once";
  for (const InputFact& input : run.inputs) EXPECT_EQ(input.bundled, input.path == shown_path(bundled));
  for (std::size_t i = 0; i < files.size(); ++i) {
    const InputFact input = test::input_in(run, files[i]);
    EXPECT_EQ(input.hash, hashes[i]);
    EXPECT_EQ(test::read_text(folder / ("run/" + input.copy)), texts[i]) << input.copy;
  }
  EXPECT_EQ(test::input_in(run, log).hash, hash_of_file(log));
  EXPECT_EQ(test::input_in(run, log).copy, "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "run/inputs"), {}), 3);
}

TEST(RunInputs, CopiesMadeAtTheBeginningAreThoseThatTheRecordNames) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "run/start");
  const std::string a = folder.write("a.yaml", "first\n");
  const std::string b = folder.write("b.yaml", "second\n");
  const std::string c = folder.write("c.yaml", "third\n");
  const std::string own = folder.write("run/start/warm.yaml", "of the run itself\n");
  const InputRecord record;
  for (const std::string& file : {a, b, c, own}) (void)read_input_file(file, 1000, "a text");
  const auto begun = keep_inputs(folder / "run", {c, b});
  ASSERT_EQ(begun.size(), 2U);
  write_run_record(folder / "run", {}, {{a, b, c, own}});  // more of them than at first
  const RunRecord run = find_run_record(folder / "run").value();
  for (const auto& [file, copy] : begun) EXPECT_EQ(test::input_in(run, file).copy, copy);
  EXPECT_EQ(test::read_text(folder / ("run/" + test::input_in(run, a).copy)), "first\n");
  EXPECT_EQ(test::input_in(run, own).copy, "") << "it is in the folder already";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "run/inputs"), {}), 3);
  EXPECT_EQ(copy_of_hash(folder / "run", hash_of_file(b)), folder / ("run/" + test::input_in(run, b).copy));
  EXPECT_EQ(copy_of_hash(folder / "run", hash_of_file(own)), std::nullopt);
}

TEST(RunInputs, CopiesBehindALinkAreNotTheRuns) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "run");
  fs::create_directories(folder / "elsewhere");
  const std::string file = folder.write("elsewhere/01_a.yaml", "first\n");
  fs::create_directory_symlink(folder / "elsewhere", folder / "run/inputs");
  EXPECT_EQ(copy_of_hash(folder / "run", hash_of_file(file)), std::nullopt);
  EXPECT_EQ(where_copies_are(folder / "run"), "");
}

TEST(RunInputs, ACopyThatSomebodyChangedIsNotTakenForTheInput) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "run");
  const std::string a = folder.write("a.yaml", "first\n");
  const InputRecord record;
  (void)read_input_file(a, 1000, "a text");
  const std::string copy = folder / ("run/" + keep_inputs(folder / "run", {a}).front().second);
  std::ofstream(copy) << "changed\n";
  const std::string again = folder / ("run/" + keep_inputs(folder / "run", {a}).front().second);
  EXPECT_NE(again, copy);
  EXPECT_EQ(test::read_text(again), "first\n");
  EXPECT_EQ(test::read_text(copy), "changed\n");
}

TEST(AppendFile, NeverGoesOnBehindALink) {
  const test::TemporaryFolder folder;
  folder.write("other.txt", "not to be written to\n");
  fs::create_symlink(folder / "other.txt", folder / "journal.txt");
  EXPECT_THAT(test::refusal(
                  [&] { AppendFile(folder / "journal.txt", AppendFile::Open::kContinue).append("more\n"); }),
              HasSubstr(folder / "journal.txt"));
  EXPECT_EQ(test::read_text(folder / "other.txt"), "not to be written to\n");
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

}  // namespace run_folder_test
}  // namespace armtune::internal
