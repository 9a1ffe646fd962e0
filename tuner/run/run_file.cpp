#include "tuner/run/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

bool leads_out(const std::string& name) {
  const fs::path path = name;
  return name.empty() || name.find('\0') != std::string::npos || path.is_absolute() ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

[[noreturn]] void refuse_link(const fs::path& path) {
  throw InputError(
      InputPlace{path.string()},
      "this is a symbolic link, which armtune does not follow inside a run's folder; put the file itself "
      "there");
}

}  // namespace

std::optional<std::string> find_run_file(const std::string& folder, const std::string& name) {
  if (leads_out(name)) {
    throw InputError(InputPlace{folder},
                     fmt::format("the name {} leads out of this folder; expected a file in it", shown(name)));
  }
  fs::path path = folder;
  fs::file_status status(fs::file_type::directory);
  for (const fs::path& part : fs::path(name)) {
    if (status.type() != fs::file_type::directory) return std::nullopt;
    path /= part;
    std::error_code error;
    status = fs::symlink_status(path, error);
    if (status.type() == fs::file_type::not_found) return std::nullopt;
    if (error)
      throw InputError(InputPlace{path.string()}, fmt::format("cannot be accessed: {}", error.message()));
    if (status.type() == fs::file_type::symlink) refuse_link(path);
  }
  if (status.type() == fs::file_type::regular) return path.string();
  throw InputError(
      InputPlace{path.string()},
      fmt::format("is {}; expected a file",
                  status.type() == fs::file_type::directory ? "a folder" : "a pipe, a device or similar"));
}

std::string run_file(const std::string& folder, const std::string& name) {
  if (auto path = find_run_file(folder, name)) return *std::move(path);
  throw InputError(fmt::format("{}/{}: no such file", folder, name));
}

void refuse_links(const std::string& folder) {
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->symlink_status(error).type() == fs::file_type::symlink) refuse_link(at->path());
    if (error) break;
  }
  if (error)
    throw InputError(InputPlace{folder}, fmt::format("cannot list this folder: {}", error.message()));
}

}  // namespace armtune::internal
