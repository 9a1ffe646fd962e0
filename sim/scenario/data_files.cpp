#include "sim/scenario/data_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "core/common/path_state.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;
constexpr const char* kExtension = ".yaml";
constexpr std::size_t kLongestName = 200;  // file systems allow 255 bytes, including the extension

bool looks_like_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(kExtension) || text.ends_with(".yml") ||
         text.ends_with(".urdf") || text.ends_with(".xml") || text.ends_with(".xacro") ||
         text.ends_with(".sdf") || text.ends_with(".mjcf");
}

}  // namespace

std::string file_beside(const std::string& path, const std::string& named_in) {
  if (path.starts_with('/')) return path;
  return without_dots(folder_of(named_in) + "/" + path);
}

std::string stem(const std::string& path) {
  return fs::path(path).stem().string();
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

bool is_bundled(const std::string& path) {
  return path.starts_with(data_folder() + "/");
}

std::string shown_path(const std::string& path) {
  const std::string data = data_folder() + "/";
  return path.starts_with(data) ? "bundled " + path.substr(data.size()) : path;
}

std::string portable_reference(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const bool bundled = path.ends_with(kExtension) && folder.parent_path() == fs::path(data_folder());
  std::string reference = bundled ? stem(path) : absolute_path(path);
  if (!is_utf8(reference)) {
    throw InputError(
        InputPlace{reference},
        "the path is not UTF-8 and cannot be written into a file; rename the file or its folder");
  }
  return reference;
}

std::string data_folder() {
  std::vector<fs::path> candidates;
  if (const char* set = std::getenv("ARMTUNE_DATA")) {
    candidates.emplace_back(set);
  } else {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) candidates.push_back(program.parent_path().parent_path() / "share/armtune");
    candidates.emplace_back(ARMTUNE_INSTALLED_DATA);
  }
  for (const fs::path& candidate : candidates) {
    if (is_there(candidate / "scenarios/.")) return candidate.string();
  }
  throw InputError(
      fmt::format("bundled data not found in {}; set ARMTUNE_DATA to the folder that holds "
                  "robots, scenarios, gains and studies",
                  candidates.front().string()));
}

std::vector<std::string> bundled_names(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::path(data_folder()) / folder, ignored)) {
    if (entry.path().extension() == kExtension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_data_file(const std::string& folder, const std::string& name_or_path,
                           const std::string& relative_to) {
  if (looks_like_path(name_or_path)) {
    std::string beside = (fs::path(relative_to) / name_or_path).string();
    if (!relative_to.empty() && is_there(beside)) return beside;
    if (is_there(name_or_path)) return name_or_path;
    throw InputError(InputPlace{name_or_path}, "no such file");
  }
  std::string bundled = (fs::path(data_folder()) / folder / (name_or_path + kExtension)).string();
  if (name_or_path.size() <= kLongestName && is_there(bundled)) return bundled;
  const auto names = bundled_names(folder);
  throw InputError(
      fmt::format(
          "there is no bundled file '{0}' in {1}{2}; the bundled files are: {3}. To use your own file, "
          "give its path, for example ./mine{4}",
          name_or_path, folder, suggestion(name_or_path, names), fmt::join(names, " "), kExtension))
      .with_value(name_or_path, fmt::format("one of: {}", fmt::join(names, ", ")));
}

}  // namespace armtune::internal
