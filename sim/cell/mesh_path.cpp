#include "sim/cell/mesh_path.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/common/file_path.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

struct Allowed {
  std::string package;  ///< package in this folder; empty: the folder contains folders of packages
  fs::path folder;
};

/// Returns the entries of an environment variable, which colons separate.
std::vector<std::string> entries_of(const char* variable) {
  const char* set = std::getenv(variable);
  std::istringstream list(set == nullptr ? "" : set);
  std::vector<std::string> entries;
  for (std::string entry; std::getline(list, entry, ':');) {
    if (!entry.empty()) entries.push_back(entry);
  }
  return entries;
}

std::vector<Allowed> allowed_folders() {
  std::vector<Allowed> folders;
  for (const std::string& entry : entries_of(kMeshFolders)) {
    const std::size_t equals = entry.find('=');
    const std::string folder = equals == std::string::npos ? entry : entry.substr(equals + 1);
    if (folder.empty()) continue;
    folders.push_back({equals == std::string::npos ? "" : entry.substr(0, equals), fs::absolute(folder)});
  }
  return folders;
}

/// Returns the name of the package in the folder's package.xml; empty if there is none.
std::string package_name(const fs::path& folder) {
  constexpr std::size_t kMostBytes = 1 << 16;
  constexpr std::string_view kOpening = "<name>";
  std::ifstream file(folder / "package.xml", std::ios::binary);
  std::string text(kMostBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t opening = text.find(kOpening);
  if (opening == std::string::npos) return {};
  const std::size_t begin = opening + kOpening.size();
  const std::size_t end = text.find("</name>", begin);
  return end == std::string::npos ? std::string() : text.substr(begin, end - begin);
}

/// Returns the folders in which ROS finds a package. Each has a package.xml with its name.
std::vector<fs::path> folders_of_ros(const std::string& package) {
  std::vector<fs::path> folders;
  for (const std::string& prefix : entries_of("AMENT_PREFIX_PATH")) {
    folders.push_back(fs::absolute(prefix) / "share" / package);
  }
  for (const std::string& entry : entries_of("ROS_PACKAGE_PATH")) {
    folders.push_back(fs::absolute(entry));
    folders.push_back(fs::absolute(entry) / package);
  }
  std::erase_if(folders, [&package](const fs::path& folder) {
    return package.empty() || package_name(folder) != package;
  });
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
  const std::vector<fs::path> above = folders_above(fs::path(absolute_path(urdf)).parent_path());
  const std::vector<Allowed> allowed = allowed_folders();
  std::vector<fs::path> roots(allowed.size());
  std::transform(allowed.begin(), allowed.end(), roots.begin(),
                 [](const Allowed& one) { return one.folder; });
  std::vector<fs::path> places;
  if (named.starts_with(kPackage)) {
    const std::string rest = named.substr(kPackage.size());
    const std::string package = rest.substr(0, rest.find('/'));
    const fs::path inside = fs::path(rest.substr(package.size())).relative_path();
    for (const Allowed& one : allowed) {
      if (one.package.empty()) places.push_back(one.folder / rest);
      if (one.package == package) places.push_back(one.folder / inside);
    }
    for (const fs::path& folder : above) {
      if (package.empty() || (folder.filename() != package && package_name(folder) != package)) continue;
      places.push_back(folder / inside);
      roots.push_back(folder);
    }
    for (const fs::path& folder : folders_of_ros(package)) {
      places.push_back(folder / inside);
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

}  // namespace armtune::internal
