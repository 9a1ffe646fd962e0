#include "tuner/run/append_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "armtune/error.hpp"
#include "core/common/write_all.hpp"
#include "sim/csv/text_file.hpp"

namespace armtune::internal {
namespace {

int flags(AppendFile::Open open) {
  switch (open) {
    case AppendFile::Open::kNew:
      return O_CREAT | O_EXCL;
    case AppendFile::Open::kReplace:  // made by make_partial_file
      return 0;
    case AppendFile::Open::kContinue:
      return O_NOFOLLOW;
  }
  return 0;
}

/// Locks the file. Tries for `patience` seconds, because the ranks of a killed run take a moment to end. If
/// that fails, returns false with the reason in errno.
bool locked(int file, double patience) {
  constexpr std::chrono::milliseconds kBetween(100);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return false;  // waiting is of no use
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(kBetween);
  }
  return true;
}

}  // namespace

AppendFile::AppendFile(const std::string& path, Open open, double patience)
    : path_(path), published_(open != Open::kReplace), texts_(open == Open::kContinue ? 2 : 0) {
  const std::string name = published_ ? path : partial_path(path);
  file_ = published_ ? ::open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags(open), 0644)
                     : make_partial_file(path, O_APPEND);
  if (file_ < 0) {
    throw InputError(InputPlace{path},
                     fmt::format("cannot {} this file: {}", open == Open::kContinue ? "open" : "create",
                                 std::strerror(errno)));
  }
  if (open != Open::kReplace && !locked(file_, patience)) {
    const int reason = errno;
    ::close(file_);
    if (open == Open::kNew && reason != EWOULDBLOCK) ::unlink(name.c_str());
    throw InputError(
        InputPlace{path},
        reason == EWOULDBLOCK
            ? "another process is writing this file; wait for that run, or stop it"
            : fmt::format("cannot lock this file against other processes: {}; use a file system that "
                          "supports locks",
                          std::strerror(reason)));
  }
  if (open == Open::kNew) sync_folder_of(path);
}

AppendFile::~AppendFile() {
  if (file_ >= 0) ::close(file_);
}

void AppendFile::fail(const char* what) const {
  throw FailedError(
      fmt::format("{}: cannot {} this file: {}{}", path_, what, std::strerror(errno),
                  texts_ > 1 ? "; it still holds all work that was finished before this error" : ""));
}

void AppendFile::append(const std::string& text, bool sync) {
  // Text that is appended to a deleted file is lost. An error now is better than one after hours of work.
  struct stat now {};
  if (::fstat(file_, &now) == 0 && now.st_nlink == 0) {
    throw FailedError(fmt::format("{}: the file was deleted during the run", path_));
  }
  if (!write_all(file_, text)) fail("append to");
  ++texts_;
  if (sync) this->sync();
}

void AppendFile::sync() {
  // A full disk may be noticed only here. A file that cannot be synced, such as a pipe, is no error.
  if (::fdatasync(file_) != 0 && errno != EINVAL && errno != EROFS) fail("append to");
}

void AppendFile::truncate(long size) {
  if (::ftruncate(file_, size) != 0) fail("shorten");
}

void AppendFile::publish() {
  if (published_) return;
  if (std::rename(partial_path(path_).c_str(), path_.c_str()) != 0) fail("replace");
  sync_folder_of(path_);
  published_ = true;
}

}  // namespace armtune::internal
