#include "tests/cli/support/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "tests/sim/support/files.hpp"

namespace armtune::internal::test {
namespace {

std::string unique_path(const char* stream) {
  static std::atomic<int> count{0};
  return testing::TempDir() + "armtune_" + stream + "_" + std::to_string(getpid()) + "_" +
         std::to_string(count++);
}

/// In the child: only calls that are safe between fork and exec.
[[noreturn]] void change_controller(char* const* arguments, const char* folder, const char* out,
                                    const char* err) {
  ::signal(SIGINT, SIG_DFL);  // a shell's background jobs ignore it, and hand that on
  const int out_file = ::open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = ::open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (::chdir(folder) == 0 && ::dup2(out_file, STDOUT_FILENO) >= 0 && ::dup2(err_file, STDERR_FILENO) >= 0) {
    ::execv(arguments[0], arguments);
  }
  ::_exit(127);
}

}  // namespace

std::string program_path() {
  return ARMTUNE_PROGRAM;
}

std::string mpiexec_path() {
#ifdef ARMTUNE_MPIEXEC
  return ARMTUNE_MPIEXEC;
#else
  return {};
#endif
}

Program::Program(const std::vector<std::string>& arguments, const std::string& folder,
                 const std::vector<std::string>& launcher)
    : out_path_(unique_path("out")), err_path_(unique_path("err")) {
  std::vector<std::string> all = launcher;
  all.push_back(program_path());
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& argument : all) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0) change_controller(pointers.data(), folder.c_str(), out_path_.c_str(), err_path_.c_str());
}

Program::~Program() {
  if (running()) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, &status_, 0);
  }
  std::error_code ignored;
  std::filesystem::remove(out_path_, ignored);
  std::filesystem::remove(err_path_, ignored);
}

void Program::interrupt() const {
  ::kill(pid_, SIGINT);
}

void Program::kill() const {
  ::kill(pid_, SIGKILL);
}

bool Program::running() {
  if (!ended_) ended_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
  return !ended_;
}

std::string Program::err_so_far() const {
  return read_text(err_path_);
}

Finished Program::wait() {
  if (!ended_) ::waitpid(pid_, &status_, 0);
  ended_ = true;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, read_text(out_path_), read_text(err_path_)};
}

Finished run_program(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  return Program(arguments, folder.path()).wait();
}

}  // namespace armtune::internal::test
