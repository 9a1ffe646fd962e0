#include "tuner/run/append_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "core/common/error.hpp"

namespace armtune {

AppendFile::AppendFile(const std::string& path) : path_(path) {
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (file_ < 0) throw InputError(fmt::format("{}: cannot make it: {}", path, std::strerror(errno)));
}

AppendFile::~AppendFile() {
  if (file_ >= 0) ::close(file_);
}

void AppendFile::append(const std::string& text) {
  const char* data = text.data();
  std::size_t left = text.size();
  while (left > 0) {
    const ssize_t written = ::write(file_, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw std::runtime_error(fmt::format("{}: cannot append to it: {}; what was finished before is in it",
                                           path_, std::strerror(errno)));
    }
    data += written;
    left -= static_cast<std::size_t>(written);
  }
  ::fdatasync(file_);
}

}  // namespace armtune
