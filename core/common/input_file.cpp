#include "core/common/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {
namespace {

using Bytes = std::shared_ptr<const std::string>;

/// By absolute path. Null: nothing is kept.
std::unique_ptr<std::map<std::string, Bytes>>
    record;               // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::mutex record_mutex;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

std::string read_file(const std::string& path, std::size_t max_bytes, const std::string& kind) {
  const auto refuse = [&](const std::string& why) { throw InputError(fmt::format("{}: {}", path, why)); };
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse("is a directory; expected " + kind);
  const auto refuse_large = [&] {
    refuse(fmt::format("larger than {} MB; expected a smaller file", max_bytes >> 20));
  };
  constexpr std::size_t kBlock = 1U << 20;
  std::size_t block = kBlock;
  std::string text;
  if (status.type() == std::filesystem::file_type::regular) {
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored && size > max_bytes) refuse_large();
    if (!ignored) block = static_cast<std::size_t>(size) + 1;  // with one more, its end is seen at once
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("cannot be opened: " + std::generic_category().message(errno));
  // Block by block, and not by its size: a pipe has none, and a file may grow.
  while (file && text.size() <= max_bytes) {
    const std::size_t before = text.size();
    text.resize(before + std::min(block, max_bytes + 1 - before));
    file.read(&text[before], static_cast<std::streamsize>(text.size() - before));
    text.resize(before + static_cast<std::size_t>(file.gcount()));
    block = kBlock;
  }
  if (file.bad()) refuse("cannot be read");
  if (text.size() > max_bytes) refuse_large();
  return text;
}

std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind) {
  if (!is_printable(path)) {
    throw InputError(fmt::format(
        "{}: the path holds a control character, a line separator or a byte that is not UTF-8, so "
        "that no file of results could name it; rename it",
        path));
  }
  if (Bytes bytes = recorded_input(path)) {
    if (bytes->size() > max_bytes)
      throw InputError(fmt::format("{}: larger than {} MB; expected a smaller file", path, max_bytes >> 20));
    return *bytes;
  }
  std::string text = read_file(path, max_bytes, kind);
  const std::lock_guard lock(record_mutex);
  if (!record) return text;
  // Another thread may have read it meanwhile: one of the two states counts.
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
