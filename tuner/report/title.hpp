#pragma once
// The title of a report page.

#include <filesystem>
#include <string>

namespace armtune::internal::report {

/// Returns a title such as "tune ur10_gaze (runs_of_today)". The folder's name in brackets is left out if it
/// equals `kind` or `what`. kind: the command; what: the study or the task, may be empty.
inline std::string page_title(const std::string& kind, const std::string& what, const std::string& folder) {
  namespace fs = std::filesystem;
  const std::string name = (fs::path(folder) / ".").lexically_normal().parent_path().filename().string();
  const bool told = name.empty() || name == "." || name == what || name == kind;
  return kind + (what.empty() ? "" : " " + what) + (told ? "" : " (" + name + ")");
}

}  // namespace armtune::internal::report
