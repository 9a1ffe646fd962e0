#include "core/common/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace input_file_test {

constexpr std::size_t kMost = 1000;

std::string read(const std::string& path) {
  return read_input_file(path, kMost, "a text");
}

TEST(InputRecord, AFileIsReadOnce) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "first");
  const InputRecord record;
  EXPECT_EQ(recorded_input(path), nullptr);
  EXPECT_EQ(read(path), "first");
  folder.write("a.txt", "second");
  EXPECT_EQ(read(path), "first");
  EXPECT_EQ(read(folder / "./a.txt"), "first") << "by whatever path";
  ASSERT_NE(recorded_input(path), nullptr);
  EXPECT_EQ(*recorded_input(path), "first");
  EXPECT_EQ(read_file(path, kMost, "a text"), "second") << "what armtune writes is read anew";
  std::filesystem::remove(path);
  EXPECT_EQ(read(path), "first");
}

TEST(InputRecord, WhatTheProgramWritesIsReadAgain) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "first");
  const InputRecord record;
  read(path);
  folder.write("a.txt", "second");
  forget_input(path);
  EXPECT_EQ(read(path), "second");
}

TEST(InputRecord, WithoutOneEveryCallReadsTheFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "first");
  {
    const InputRecord ended;
    read(path);
  }
  folder.write("a.txt", "second");
  EXPECT_EQ(read(path), "second");
  EXPECT_EQ(recorded_input(path), nullptr);
}

TEST(InputRecord, ThreadsSeeOneState) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", std::string(100, 'a'));
  const InputRecord record;
  std::vector<std::string> seen(8);
  std::vector<std::thread> threads;
  for (std::string& text : seen) {
    threads.emplace_back([&text, &path] { text = read(path); });
    folder.write("a.txt", std::string(100, static_cast<char>('b' + threads.size())));
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : seen) EXPECT_EQ(text, *recorded_input(path));
}

TEST(InputRecord, ASmallerLimitHoldsForWhatIsRecorded) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "0123456789");
  const InputRecord record;
  read(path);
  EXPECT_THAT([&] { (void)read_input_file(path, 5, "a text"); }, test::refused_at({.file = path}));
}

TEST(ReadFile, APipeIsWaitedForAndReadToItsEnd) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&path] {
    std::ofstream pipe(path);
    for (const char* part : {"one ", "two ", "three"}) {
      pipe << part << std::flush;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  const std::string text = read_file(path, kMost, "a text");
  writer.join();
  EXPECT_EQ(text, "one two three");
}

TEST(ReadFile, ASignalEndsTheWaitForAPipe) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const auto before = std::signal(SIGUSR1, [](int) {});
  std::atomic<bool> ended{false};
  std::string refusal;
  std::thread reader([&] {
    refusal = test::refusal([&] { (void)read_file(path, kMost, "a text"); });
    ended = true;
  });
  // Again until it arrives in the wait itself; without an end the test runs into its limit.
  while (!ended) {
    pthread_kill(reader.native_handle(), SIGUSR1);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  reader.join();
  std::signal(SIGUSR1, before);
  EXPECT_THAT(refusal, testing::AllOf(testing::HasSubstr(path), testing::HasSubstr("interrupted")));
}

TEST(ReadInputFile, APathThatNoFileCouldNameIsRefusedAndShownEscaped) {
  const test::TemporaryFolder folder;
  for (const auto& [name, shown] : {std::pair<std::string, std::string>("a\x1b[31m", "a\\x1b[31m"),
                                    {"a\x7f", "a\\x7f"},
                                    {"a\rb", "a\\x0db"},
                                    {"a\xC2\x85", "a\\x85"},
                                    {"a\xE2\x80\xA8", "a\\u2028"},
                                    {"caf\xE9", "caf\\xe9"}}) {
    const std::string path = folder.write(name, "text");
    EXPECT_THAT(test::refusal([&] { (void)read(path); }), testing::HasSubstr(folder / shown));
    EXPECT_THAT([&] { (void)read(path); }, test::refused_at({.file = path}));
  }
  EXPECT_EQ(read(folder.write("é: \xF0\x9F\xA4\x96 #1", "text")), "text");
}

}  // namespace input_file_test
}  // namespace armtune::internal
