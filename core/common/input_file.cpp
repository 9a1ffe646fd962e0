#include "core/common/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/common/error.hpp"

namespace armtune {

std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind) {
  const auto refuse = [&](const std::string& why) { throw InputError(fmt::format("{}: {}", path, why)); };
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse("is a directory; expected " + kind);
  const auto refuse_large = [&] {
    refuse(fmt::format("larger than {} MB; expected a smaller file", max_bytes >> 20));
  };
  constexpr std::size_t kBlock = 1U << 20;
  std::string text;
  if (status.type() == std::filesystem::file_type::regular) {
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored && size > max_bytes) refuse_large();
    if (!ignored) text.reserve(static_cast<std::size_t>(size) + kBlock);
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("cannot be opened: " + std::generic_category().message(errno));
  // Block by block, and not by its size: a pipe has none, and a file may grow.
  while (file && text.size() <= max_bytes) {
    const std::size_t before = text.size();
    text.resize(before + std::min(kBlock, max_bytes + 1 - before));
    file.read(&text[before], static_cast<std::streamsize>(text.size() - before));
    text.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) refuse("cannot be read");
  if (text.size() > max_bytes) refuse_large();
  return text;
}

}  // namespace armtune
