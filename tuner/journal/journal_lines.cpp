#include "tuner/journal/journal_lines.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/path_state.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kDigits = 16;
constexpr std::size_t kMaxLine = std::size_t{64} << 20;  // 64 MB; a record of 1,000 scenarios takes 1 MB

std::string checksum(std::string_view payload) {
  Fnv1a hash;
  hash.add(payload);
  return fmt::format("{:016x}", hash.value());
}

}  // namespace

std::string checked_line(std::string_view payload) {
  return fmt::format("{} {}\n", checksum(payload), payload);
}

std::optional<std::string_view> payload_of(std::string_view line) {
  if (line.size() <= kDigits || line[kDigits] != ' ') return std::nullopt;
  const std::string_view payload = line.substr(kDigits + 1);
  if (line.substr(0, kDigits) != checksum(payload)) return std::nullopt;
  return payload;
}

JournalLines::JournalLines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) {
    const int reason = errno;
    if (is_there(path))
      throw InputError(InputPlace{path},
                       fmt::format("cannot be opened: {}", std::generic_category().message(reason)));
    throw InputError(InputPlace{path}, "cannot be read, so there is no run to resume; start the run again");
  }
}

bool JournalLines::next() {
  place_ += static_cast<long>(line_.size()) + (whole_ ? 1 : 0);
  whole_ = false;
  line_.clear();
  try {
    read_line();
  } catch (const std::ios_base::failure& e) {
    throw InputError(InputPlace{path_}, fmt::format("cannot be read: {}", e.what()));
  }
  if (!whole_ && line_.empty()) return false;
  ++number_;
  return true;
}

std::optional<std::string_view> JournalLines::payload() const {
  return whole_ ? payload_of(line_) : std::nullopt;
}

/// Reads a line. std::getline would fill the memory with a line that never ends.
void JournalLines::read_line() {
  std::streambuf& bytes = *file_.rdbuf();
  for (int byte = bytes.sbumpc(); byte != std::char_traits<char>::eof(); byte = bytes.sbumpc()) {
    if (byte == '\n') {
      whole_ = true;
      break;
    }
    if (line_.size() == kMaxLine) {
      throw InputError(
          at_line(path_, number_ + 1),
          fmt::format("this line has more than {} MB; the file is not an armtune journal, or it is "
                      "damaged",
                      kMaxLine >> 20))
          .with_value({}, fmt::format("lines of at most {} MB", kMaxLine >> 20));
    }
    line_ += static_cast<char>(byte);
  }
}

}  // namespace armtune::internal
