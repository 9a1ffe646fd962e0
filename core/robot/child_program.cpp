#include "core/robot/child_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <sstream>
#include <utility>

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr long kPause = 10'000'000;  // ns, between two looks at the program
constexpr std::size_t kMostErrors = 64U << 10U;

/// A temporary file that has lost its name, so that nothing is left of it whatever happens.
class NamelessFile {
 public:
  NamelessFile() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error) folder = "/tmp";
    std::string path = folder / "armtune_XXXXXX";
    descriptor_ = ::mkostemp(path.data(), O_CLOEXEC);
    if (is_open()) ::unlink(path.c_str());
  }
  ~NamelessFile() {
    if (is_open()) ::close(descriptor_);
  }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

  std::size_t size() const {
    struct stat status {};
    return ::fstat(descriptor_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
  }

  std::string text(std::size_t most) const {
    std::string bytes(std::min(size(), most), '\0');
    std::size_t got = 0;
    while (got < bytes.size()) {
      const ssize_t read = ::pread(descriptor_, &bytes[got], bytes.size() - got, static_cast<off_t>(got));
      if (read <= 0) break;
      got += static_cast<std::size_t>(read);
    }
    bytes.resize(got);
    return bytes;
  }

 private:
  int descriptor_ = -1;
};

/// The settings of a program that is about to start: where its streams lead, and a process group of its own.
class SpawnSettings {
 public:
  SpawnSettings(const NamelessFile& out, const NamelessFile& err) {
    ::posix_spawn_file_actions_init(&streams_);
    ::posix_spawn_file_actions_addopen(&streams_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&streams_, out.descriptor(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&streams_, err.descriptor(), STDERR_FILENO);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t changed;
    ::sigemptyset(&changed);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) ::sigaddset(&changed, signal);
    ::posix_spawnattr_setsigdefault(&attributes_, &changed);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&streams_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  /// Returns 0, or the errno of the failure.
  int start(std::vector<std::string> words, pid_t& pid) const {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int failure =
        ::posix_spawn(&pid, pointers.front(), &streams_, &attributes_, pointers.data(), environ);
    return failure;
  }

 private:
  posix_spawn_file_actions_t streams_{};
  posix_spawnattr_t attributes_{};
};

/// Waits for the end of the program, or for a reason to kill it. Returns the reason, and the status of
/// waitpid.
std::pair<ChildEnd, int> wait_for(pid_t pid, const ChildLimits& limits, const NamelessFile& out,
                                  const NamelessFile& err) {
  using Clock = std::chrono::steady_clock;
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.time));
  int status = 0;
  ChildEnd reason = ChildEnd::kExited;
  while (reason == ChildEnd::kExited) {
    const pid_t ended = ::waitpid(pid, &status, WNOHANG);
    if (ended == pid) return {WIFEXITED(status) ? ChildEnd::kExited : ChildEnd::kKilled, status};
    if (ended < 0 && errno != EINTR) return {ChildEnd::kKilled, status};
    if (out.size() > limits.bytes || err.size() > limits.bytes) reason = ChildEnd::kTooLarge;
    if (Clock::now() >= until) reason = ChildEnd::kTooSlow;
    const timespec pause{0, kPause};
    if (reason == ChildEnd::kExited && ::nanosleep(&pause, nullptr) != 0 && errno == EINTR)
      reason = ChildEnd::kInterrupted;
  }
  ::kill(-pid, SIGKILL);  // the whole process group
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return {reason, status};
}

}  // namespace

std::optional<std::string> program_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.starts_with('/')) continue;
    const std::string program = folder + "/" + name;
    std::error_code error;
    if (fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

ChildOutcome run_child(const std::vector<std::string>& words, const ChildLimits& limits) {
  const NamelessFile out;
  const NamelessFile err;
  ChildOutcome outcome;
  if (!out.is_open() || !err.is_open()) {
    outcome.exit_code = errno;
    return outcome;
  }
  pid_t pid = -1;
  outcome.exit_code = SpawnSettings(out, err).start(words, pid);
  if (outcome.exit_code != 0) return outcome;
  const auto [end, status] = wait_for(pid, limits, out, err);
  outcome.end = end == ChildEnd::kExited && out.size() > limits.bytes ? ChildEnd::kTooLarge : end;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (outcome.end == ChildEnd::kExited) outcome.out = out.text(limits.bytes);
  outcome.err = err.text(kMostErrors);
  return outcome;
}

}  // namespace armtune::internal
