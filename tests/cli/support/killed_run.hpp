#pragma once
// Kills commands under way, and compares the files of runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"

namespace armtune::internal::test {

/// The number of lines of a file, or 0 if there is none.
inline std::size_t lines_of(const std::string& path) {
  if (!std::filesystem::exists(path)) return 0;
  const std::string text = read_text(path);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The number of finished evaluations in a journal, or 0 if there is none.
inline std::size_t finished_in(const std::string& journal) {
  if (!std::filesystem::exists(journal)) return 0;
  const std::string text = read_text(journal);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("finished\t", at)) != std::string::npos; ++at) ++count;
  return count;
}

/// Starts the command and kills it once its journal holds that many finished ones.
inline void run_and_kill(const std::vector<std::string>& arguments, const std::string& journal,
                         std::size_t finished) {
  const TemporaryFolder folder;
  Program program(arguments, folder.path());
  while (program.running() && finished_in(journal) < finished) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.kill();
  EXPECT_EQ(program.wait().exit_code, -1) << "it was to be killed under way";
}

/// Expects the files to be byte-identical, but for wall times.
inline void expect_same_run(const std::string& a, const std::string& b,
                            const std::vector<std::string>& files) {
  EXPECT_EQ(without_time(a + "/evaluations.csv"), without_time(b + "/evaluations.csv"));
  for (const std::string& file : files) {
    EXPECT_NE(read_text(a + "/" + file), "") << file;
    EXPECT_EQ(read_text(a + "/" + file), read_text(b + "/" + file)) << file;
  }
}

}  // namespace armtune::internal::test
