#pragma once
// Runs commands as ranks of mpirun, and waits for what they write and say.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal::test {

/// Tests of commands that run as ranks below mpirun.
class Ranks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (mpiexec_path().empty()) GTEST_SKIP() << "built without MPI";
    // Containers run tests as root, which mpirun refuses unless told otherwise.
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  }

  static std::vector<std::string> launcher(int ranks) {
    return {mpiexec_path(), "--oversubscribe", "--bind-to", "none", "-n", std::to_string(ranks)};
  }
  Finished run(int ranks, const std::vector<std::string>& arguments) const {
    return Program(arguments, folder_.path(), launcher(ranks)).wait();
  }
  /// The launcher of two ranks, the first with arguments of its own and the second with those to come. Each
  /// leaves its exit code in a file (code_of).
  std::vector<std::string> launcher_of_two(const std::vector<std::string>& first) const {
    std::vector<std::string> all = {mpiexec_path(), "--oversubscribe", "--bind-to", "none"};
    const auto add_rank = [&](int rank) {
      const std::string script = "\"$@\"; echo $? > '" + folder_ / ("code." + std::to_string(rank)) + "'";
      for (const std::string& word : std::vector<std::string>{"-n", "1", "sh", "-c", script, "sh"})
        all.push_back(word);
    };
    add_rank(0);
    all.emplace_back(program_path());
    all.insert(all.end(), first.begin(), first.end());
    all.emplace_back(":");
    add_rank(1);
    return all;
  }
  std::string code_of(int rank) const { return read_text(folder_ / ("code." + std::to_string(rank))); }
  Finished alone(const std::vector<std::string>& arguments) const {
    return Program(arguments, folder_.path()).wait();
  }
  static std::vector<std::string> tune(const std::string& study, const std::string& out,
                                       const std::vector<std::string>& more, const char* evaluations = "6") {
    std::vector<std::string> all = {"tune",     study, "--out", out, "--no-analysis", "--max-evaluations",
                                    evaluations};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryFolder folder_;
};

/// The number of rows of a CSV file, without its header.
inline long rows(const std::string& path) {
  const std::string text = read_text(path);
  return std::count(text.begin(), text.end(), '\n') - 1;
}

/// True if the file has that many rows while the program is still running.
inline bool wait_for_rows(Program& program, const std::string& path, long count) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (rows(path) < count && program.running() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return rows(path) >= count && program.running();
}

/// Process number of a rank below that mpirun, or 0.
inline int process_of(const Program& mpirun, int rank) {
  const std::string children = "/proc/" + std::to_string(mpirun.pid()) + "/task/";
  for (const auto& task : std::filesystem::directory_iterator(children)) {
    std::istringstream numbers(read_text(task.path().string() + "/children"));
    for (int pid = 0; numbers >> pid;) {
      const std::string environment = read_text("/proc/" + std::to_string(pid) + "/environ");
      const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank);
      if (('\0' + environment).find('\0' + wanted + '\0') != std::string::npos) return pid;
    }
  }
  return 0;
}

/// True if the program says `text` on its standard error within that time.
inline bool wait_for_error(Program& program, const std::string& text, std::chrono::seconds longest) {
  const auto deadline = std::chrono::steady_clock::now() + longest;
  const auto said = [&] { return program.err_so_far().find(text) != std::string::npos; };
  while (!said() && program.running() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return said();
}

/// True if the program ends within that time.
inline bool wait_for_end(Program& program, std::chrono::seconds longest) {
  const auto deadline = std::chrono::steady_clock::now() + longest;
  while (program.running() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return !program.running();
}

/// How often `what` stands in the text.
inline std::size_t times_said(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

}  // namespace armtune::internal::test
