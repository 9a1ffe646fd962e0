#include "core/common/path_state.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::error_code& why) {
  throw InputError(
      InputPlace{path},
      fmt::format("cannot be accessed: {}; name another path, or remove the cause", why.message()));
}

}  // namespace

bool is_there(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return false;
  if (error) refuse(path, error);
  return true;
}

void refuse_existing(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::none) refuse(path, error);
  throw InputError(InputPlace{path}, "exists already; name another file, or remove this one");
}

bool is_missing_or_empty(const std::string& folder) {
  if (!is_there(folder)) return true;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->symlink_status(error).type() != fs::file_type::directory && !error) return false;
  }
  if (error) refuse(folder, error);
  return true;
}

}  // namespace armtune::internal
