#include "sim/csv/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/path_state.hpp"
#include "core/common/write_all.hpp"

namespace armtune::internal {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw InputError(InputPlace{path}, fmt::format("cannot {}: {}", what, std::strerror(errno)));
}

/// Throws the InputError for a temporary file that could not be created. The message names `path`, as the
/// user did, unless something else exists in the place of the temporary file.
[[noreturn]] void fail_to_make(const std::string& path) {
  const int reason = errno;
  const std::string parent = std::filesystem::path(path).parent_path().string();
  std::error_code ignored;
  if (!parent.empty() && (reason == ENOENT || reason == ENOTDIR) &&
      !std::filesystem::is_directory(parent, ignored)) {
    throw InputError(
        InputPlace{path},
        fmt::format("cannot write this file: there is no folder {}; create the folder, or name another file",
                    parent));
  }
  errno = reason;
  fail(reason == EEXIST ? partial_path(path) : path, "write it");  // the user can remove what is there
}

/// Deletes the incomplete temporary file, then throws InputError.
[[noreturn]] void give_up(const std::string& partial, const std::string& path, const char* what) {
  const int reason = errno;
  ::unlink(partial.c_str());
  errno = reason;
  fail(path, what);
}

/// Writes the text to a temporary file beside `path`, flushes it to the disk and returns its path. If this
/// fails, throws InputError and leaves no file.
std::string write_partial(const std::string& path, std::string_view text) {
  std::string partial = partial_path(path);
  const int file = make_partial_file(path);
  if (file < 0) fail_to_make(path);
  if (!write_all(file, text)) {
    const int reason = errno;
    ::close(file);
    errno = reason;
    give_up(partial, path, "write it");
  }
  const bool synced = ::fsync(file) == 0;
  if (::close(file) != 0 || !synced) give_up(partial, path, "write it");
  return partial;
}

}  // namespace

std::string partial_path(const std::string& path) {
  return path + ".armtune.partial";
}

int make_partial_file(const std::string& path, int flags) {
  forget_input(path);
  const std::string partial = partial_path(path);
  ::unlink(partial.c_str());  // left by a killed run; if it cannot be deleted, open() fails
  return ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC | flags, 0644);
}

void write_text_file(const std::string& path, std::string_view text) {
  const std::string partial = write_partial(path, text);
  if (std::rename(partial.c_str(), path.c_str()) != 0) give_up(partial, path, "replace it");
  sync_folder_of(path);
}

void write_new_text_file(const std::string& path, std::string_view text) {
  refuse_existing(path);
  const std::string partial = write_partial(path, text);
  bool placed = ::renameat2(AT_FDCWD, partial.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) == 0;
  // Some file systems have no RENAME_NOREPLACE. There a link is made instead, which does not replace a file
  // either. File systems without links answer EPERM; only there a file that appears at this moment is lost.
  if (!placed && (errno == EINVAL || errno == ENOSYS))
    placed = ::link(partial.c_str(), path.c_str()) == 0 && ::unlink(partial.c_str()) == 0;
  if (!placed && errno == EPERM) placed = std::rename(partial.c_str(), path.c_str()) == 0;
  if (!placed) give_up(partial, path, "create it");
  sync_folder_of(path);
}

void sync_folder_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  const int folder = ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    throw InputError(InputPlace{path},
                     fmt::format("cannot create this folder: {}",
                                 error ? error.message() : std::string("a file with this name exists")));
  }
}

}  // namespace armtune::internal
