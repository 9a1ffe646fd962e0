#include "tuner/cli/readable_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace armtune::internal::cli {

CLI::Validator readable_file() {
  const auto trouble = [](std::string& path) -> std::string {
    if (::access(path.c_str(), R_OK) != 0)
      return fmt::format("{}: cannot be read: {}", path, std::generic_category().message(errno));
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return path + ": is a folder; name a file in it";
    return {};
  };
  return CLI::Validator(trouble, "FILE");
}

}  // namespace armtune::internal::cli
