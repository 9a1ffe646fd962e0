#include "sim/csv/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kLongestLine = 1U << 20;

}  // namespace

TextLines::TextLines(const std::string& path) : path_(path), buffer_(kLongestLine) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status))
    throw InputError(InputPlace{path}, "is a folder; name a file in it").with_value({}, "a regular file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw InputError(InputPlace{path},
                     "is not a regular file; a log is read more than once, so save it to a file first")
        .with_value({}, "a regular file");
  }
  file_.open(path, std::ios::binary);
  if (!file_)
    throw InputError(InputPlace{path},
                     fmt::format("cannot be opened: {}", std::generic_category().message(errno)));
}

bool TextLines::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) {
    throw InputError(at_line(path_, number_ + 1),
                     "this line has more than 1 MB; a log has one row of numbers on each line")
        .with_value({}, "lines of at most 1 MB");
  }
  file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  if (file_.bad()) throw InputError(at_line(path_, number_ + 1), "cannot be read");
  const auto read = static_cast<std::size_t>(file_.gcount());
  end_ += read;
  return read > 0;
}

bool TextLines::next() {
  if (after_cr_ && (begin_ < end_ || fill()) && buffer_[begin_] == '\n') ++begin_;
  after_cr_ = false;
  std::size_t searched = 0;
  while (true) {
    const std::string_view waiting(buffer_.data() + begin_, end_ - begin_);
    const std::size_t length = waiting.find_first_of("\r\n", searched);
    if (length != std::string_view::npos) {
      line_ = waiting.substr(0, length);
      after_cr_ = waiting[length] == '\r';
      begin_ += length + 1;
      break;
    }
    searched = waiting.size();
    if (fill()) continue;
    if (begin_ == end_) return false;
    line_ = std::string_view(buffer_.data() + begin_, end_ - begin_);
    begin_ = end_;
    break;
  }
  ++number_;
  return true;
}

}  // namespace armtune::internal
