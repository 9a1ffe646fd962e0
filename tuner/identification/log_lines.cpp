#include "tuner/identification/log_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMaxLineBytes = 1U << 20;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\"");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\"") - begin + 1);
}

long count_outside_quotes(std::string_view line, char what) {
  long count = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == what && !quoted) ++count;
  }
  return count;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  constexpr std::string_view kBlanks = " \t";
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = line.find_first_not_of(kBlanks, end);
  }
}

}  // namespace

LogLines::LogLines(const std::string& path) : path_(path), buffer_(kMaxLineBytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw InputError(fmt::format(
        "{}: is not a regular file; a log is read more than once, so save it to a file first", path));
  }
  file_.open(path, std::ios::binary);
  if (!file_)
    throw InputError(fmt::format("{}: cannot be opened: {}", path, std::generic_category().message(errno)));
}

bool LogLines::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) {
    throw InputError(
        fmt::format("{}:{}: this line has more than 1 MB; a log has one row of numbers on each line", path_,
                    number_ + 1));
  }
  file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  if (file_.bad()) throw InputError(fmt::format("{}:{}: cannot be read", path_, number_ + 1));
  const auto read = static_cast<std::size_t>(file_.gcount());
  hash_.add(std::string_view(buffer_.data() + end_, read));
  end_ += read;
  return read > 0;
}

bool LogLines::next() {
  if (repeat_) {
    repeat_ = false;
    return true;
  }
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

char find_separator(std::string_view first_line) {
  char most = ' ';
  long count = 0;
  for (const char separator : {',', ';', '\t'}) {
    const long here = count_outside_quotes(first_line, separator);
    if (here <= count) continue;
    count = here;
    most = separator;
  }
  return most;
}

std::string_view separator_name(char separator) {
  switch (separator) {
    case ',':
      return "commas";
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    default:
      return "blanks";
  }
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') return split_at_blanks(line, cells);
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != separator || quoted) continue;
    cells.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
}

}  // namespace armtune::internal
