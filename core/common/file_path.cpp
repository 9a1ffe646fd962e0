#include "core/common/file_path.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "armtune/error.hpp"

namespace armtune::internal {

namespace fs = std::filesystem;

std::string without_dots(const std::string& path) {
  fs::path plain;
  for (const fs::path& part : fs::path(path)) {
    if (part.empty() || part == ".") continue;
    std::error_code ignored;
    const bool above_root = part == ".." && plain.has_root_directory() && !plain.has_filename();
    const bool of_folder = part == ".." && plain.has_filename() && plain.filename() != ".." &&
                           fs::symlink_status(plain, ignored).type() == fs::file_type::directory;
    if (of_folder) {
      plain = plain.parent_path();
    } else if (!above_root) {
      plain /= part;
    }
  }
  return plain.empty() ? "." : plain.string();
}

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) {
    throw InputError(fmt::format("the current folder cannot be found: {}; change to a folder that exists",
                                 error.message()));
  }
  return without_dots(absolute.string());
}

}  // namespace armtune::internal
