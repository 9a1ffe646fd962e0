#include "sim/csv/partial_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/write_all.hpp"
#include "sim/csv/text_file.hpp"

namespace armtune::internal {
namespace {

[[noreturn]] void fail_at(const std::string& path, const char* what) {
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
  fail_at(reason == EEXIST ? partial_path(path) : path, "write it");  // the user can remove what is there
}

}  // namespace

PartialFile::PartialFile(const std::string& path)
    : path_(path), partial_(partial_path(path)), descriptor_(make_partial_file(path)) {
  if (descriptor_ < 0) fail_to_make(path);
}

PartialFile::~PartialFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!partial_.empty()) ::unlink(partial_.c_str());
}

void PartialFile::fail(const char* what) const {
  fail_at(path_, what);
}

void PartialFile::write(std::string_view bytes) {
  if (!write_all(descriptor_, bytes)) fail("write it");
}

void PartialFile::close() {
  const bool synced = ::fsync(descriptor_) == 0;
  const int reason = errno;
  const bool closed = ::close(descriptor_) == 0;
  descriptor_ = -1;
  if (!synced) errno = reason;
  if (!synced || !closed) fail("write it");
}

void PartialFile::replace() {
  close();
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail("replace it");
  partial_.clear();
  sync_folder_of(path_);
}

void PartialFile::place_new() {
  close();
  bool placed = ::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) == 0;
  // Some file systems have no RENAME_NOREPLACE. There a link is made instead, which does not replace a file
  // either. File systems without links answer EPERM; only there a file that appears at this moment is lost.
  if (!placed && (errno == EINVAL || errno == ENOSYS))
    placed = ::link(partial_.c_str(), path_.c_str()) == 0 && ::unlink(partial_.c_str()) == 0;
  if (!placed && errno == EPERM) placed = std::rename(partial_.c_str(), path_.c_str()) == 0;
  if (!placed) fail("create it");
  partial_.clear();
  sync_folder_of(path_);
}

}  // namespace armtune::internal
