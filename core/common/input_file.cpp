#include "core/common/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {
namespace {

using Bytes = std::shared_ptr<const std::string>;

/// The contents of files that were read, by absolute path. Null: contents are not recorded.
std::unique_ptr<std::map<std::string, Bytes>>
    record;               // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::mutex record_mutex;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

constexpr std::size_t kLeastBlock = 1U << 12;
constexpr std::size_t kMostBlock = 1U << 20;

/// Reads a file, pipe or device. A signal ends the wait for a pipe; a stream of the standard library would
/// continue to wait.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~OpenFile() {
    if (is_open()) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  /// Waits for bytes and returns their number. Returns 0 at the end, and a negative number with errno after a
  /// failure (EINTR after a signal).
  ssize_t read(char* to, std::size_t most) const {
    while (true) {
      pollfd wanted{descriptor_, POLLIN, 0};
      if (::poll(&wanted, 1, -1) < 0) return -1;
      const ssize_t read = ::read(descriptor_, to, most);
      if (read >= 0 || errno != EAGAIN) return read;  // another reader of the pipe may have been faster
    }
  }

 private:
  int descriptor_;
};

}  // namespace

void refuse_large(const std::string& path, std::size_t max_bytes) {
  const std::size_t megabytes = max_bytes >> 20;
  throw InputError(InputPlace{path}, fmt::format("larger than {} MB; expected a smaller file", megabytes))
      .with_value({}, fmt::format("at most {} MB", megabytes));
}

std::string read_file(const std::string& path, std::size_t max_bytes, const std::string& kind) {
  const auto refuse = [&](const std::string& why) { throw InputError(InputPlace{path}, why); };
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
  if (status.type() == std::filesystem::file_type::directory)
    throw InputError(InputPlace{path}, InputFault{.problem = "is a directory", .limit = kind});
  std::size_t block = kMostBlock;
  if (status.type() == std::filesystem::file_type::regular) {
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored && size > max_bytes) refuse_large(path, max_bytes);
    if (!ignored) block = static_cast<std::size_t>(size) + 1;  // not 0, even if the file reports no size
  }
  const OpenFile file(path);
  if (!file.is_open()) refuse("cannot be opened: " + std::generic_category().message(errno));
  // Reads block by block and not by the size: a pipe has no size, and a file may grow. Where the first block
  // is a whole file, the next one only finds its end, and is small.
  std::string text;
  for (std::size_t got = 1; got > 0 && text.size() <= max_bytes;
       block = std::clamp(text.size(), kLeastBlock, kMostBlock)) {
    const std::size_t before = text.size();
    text.resize(before + std::min(block, max_bytes + 1 - before));
    const ssize_t read = file.read(&text[before], text.size() - before);
    if (read < 0 && errno == EINTR) refuse("reading it was interrupted");
    if (read < 0) refuse("cannot be read: " + std::generic_category().message(errno));
    got = static_cast<std::size_t>(read);
    text.resize(before + got);
  }
  if (text.size() > max_bytes) refuse_large(path, max_bytes);
  return text;
}

std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind) {
  if (!is_printable(path)) {
    throw InputError(
        InputPlace{path},
        "the path contains a control character, a line separator or a byte that is not UTF-8, which "
        "result files cannot contain; rename it");
  }
  if (Bytes bytes = recorded_input(path)) {
    if (bytes->size() > max_bytes) refuse_large(path, max_bytes);
    return *bytes;
  }
  std::string text = read_file(path, max_bytes, kind);
  const std::lock_guard lock(record_mutex);
  if (!record) return text;
  // Another thread may have recorded the file meanwhile. All callers then get the bytes that it read.
  return *record->try_emplace(absolute_path(path), std::make_shared<const std::string>(std::move(text)))
              .first->second;
}

InputRecord::InputRecord() {
  const std::lock_guard lock(record_mutex);
  record = std::make_unique<std::map<std::string, Bytes>>();
}

InputRecord::~InputRecord() {
  const std::lock_guard lock(record_mutex);
  record.reset();
}

std::shared_ptr<const std::string> recorded_input(const std::string& path) {
  const std::lock_guard lock(record_mutex);
  if (!record) return nullptr;
  const auto found = record->find(absolute_path(path));
  return found == record->end() ? nullptr : found->second;
}

void forget_input(const std::string& path) {
  const std::lock_guard lock(record_mutex);
  if (record) record->erase(absolute_path(path));
}

}  // namespace armtune::internal
