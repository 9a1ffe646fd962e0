#include "sim/logs/byte_source.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kFirstBuffer = 256U << 10;  // bytes: stays in a processor's cache while it is hashed

[[noreturn]] void refuse_source(const std::string& path, const std::string& why) {
  throw InputError(InputPlace{path}, why);
}

}  // namespace

ByteSource::ByteSource(const std::filesystem::path& path, const std::string& kind)
    : path_(path.string()), buffer_(kFirstBuffer) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found) refuse_source(path_, "no such file");
  if (status.type() == std::filesystem::file_type::directory)
    throw InputError(InputPlace{path_}, InputFault{.problem = "is a directory", .limit = kind});
  // Without O_NONBLOCK a signal could not end the wait for the writer of a pipe.
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) refuse_source(path_, "cannot be opened: " + std::generic_category().message(errno));
}

ByteSource::~ByteSource() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t ByteSource::read(std::byte* to, std::size_t most) const {
  while (true) {
    pollfd wanted{descriptor_, POLLIN, 0};
    const bool ready = ::poll(&wanted, 1, -1) >= 0;
    const ssize_t got = ready ? ::read(descriptor_, to, most) : -1;
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno == EINTR) refuse_source(path_, "reading it was interrupted");
    if (errno != EAGAIN) refuse_source(path_, "cannot be read: " + std::generic_category().message(errno));
  }
}

void ByteSource::hash_skipped() {
  crc_.add(std::span(buffer_).subspan(hashed_, begin_ - hashed_));
  hashed_ = begin_;
}

std::span<const std::byte> ByteSource::peek(std::size_t count) {
  if (end_ - begin_ < count) {
    hash_skipped();
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    offset_of_buffer_ += begin_;
    end_ -= begin_;
    begin_ = hashed_ = 0;
    while (end_ < count) {
      if (end_ == buffer_.size()) buffer_.resize(std::min(count, 2 * buffer_.size()));
      const std::size_t got = read(buffer_.data() + end_, buffer_.size() - end_);
      if (got == 0) break;
      end_ += got;
    }
  }
  return std::span(buffer_).subspan(begin_, std::min(count, end_ - begin_));
}

bool ByteSource::pass(std::uint64_t count) {
  while (count > 0) {
    const std::size_t got =
        peek(static_cast<std::size_t>(std::min<std::uint64_t>(count, kFirstBuffer))).size();
    if (got == 0) return false;
    skip(got);
    count -= got;
  }
  return true;
}

std::uint32_t ByteSource::crc() {
  hash_skipped();
  return crc_.value();
}

void ByteSource::restart_crc() {
  hash_skipped();
  crc_ = Crc32();
}

bool ByteSource::ends_with(std::span<const std::byte> bytes) const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  const off_t begin = status.st_size - static_cast<off_t>(bytes.size());
  std::vector<std::byte> last(bytes.size());
  return begin >= 0 &&
         ::pread(descriptor_, last.data(), last.size(), begin) == static_cast<ssize_t>(last.size()) &&
         std::equal(last.begin(), last.end(), bytes.begin());
}

}  // namespace armtune::internal
