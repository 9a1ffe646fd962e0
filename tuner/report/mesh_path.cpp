#include "tuner/report/mesh_path.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <vector>

namespace armtune::report {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> allowed_folders() {
  std::vector<fs::path> folders;
  const char* set = std::getenv(kMeshFolders);
  std::istringstream list(set == nullptr ? "" : set);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(fs::absolute(folder));
  }
  return folders;
}

std::vector<fs::path> folders_above(const fs::path& folder) {
  std::vector<fs::path> above = {folder};
  while (above.back() != above.back().parent_path()) above.push_back(above.back().parent_path());
  return above;
}

fs::path folder_of_robot(const std::vector<fs::path>& above) {
  std::error_code ignored;
  for (const fs::path& folder : above) {
    if (fs::exists(folder / "package.xml", ignored)) return folder;
  }
  return above.front().filename() == "urdf" ? above.front().parent_path() : above.front();
}

bool is_within(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return false;
  return std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

}  // namespace

std::optional<std::string> mesh_path(const std::string& named, const std::string& urdf) {
  constexpr std::string_view kPackage = "package://";
  constexpr std::string_view kFile = "file://";
  const std::vector<fs::path> above = folders_above(fs::absolute(urdf).lexically_normal().parent_path());
  std::vector<fs::path> roots = allowed_folders();
  std::vector<fs::path> places;
  if (named.starts_with(kPackage)) {
    const std::string rest = named.substr(kPackage.size());
    const std::string package = rest.substr(0, rest.find('/'));
    for (const fs::path& root : roots) places.push_back(root / rest);
    for (const fs::path& folder : above) {
      if (package.empty() || folder.filename() != package) continue;
      places.push_back(folder.parent_path() / rest);
      roots.push_back(folder);
    }
  } else {
    places.push_back(named.starts_with(kFile) ? fs::path(named.substr(kFile.size())) : above.front() / named);
  }
  roots.push_back(folder_of_robot(above));
  for (const fs::path& place : places) {
    std::error_code error;
    const fs::path file = fs::canonical(place, error);
    if (error || !fs::is_regular_file(file, error)) continue;
    const auto holds = [&file](const fs::path& root) { return is_within(file, root); };
    if (std::any_of(roots.begin(), roots.end(), holds)) return file.string();
  }
  return std::nullopt;
}

}  // namespace armtune::report
