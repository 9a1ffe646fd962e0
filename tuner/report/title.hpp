#pragma once
// What a page is called.

#include <filesystem>
#include <string>

namespace armtune::internal::report {

/// "tune ur10_gaze (runs_of_today)": the folder's own name where it says more than the rest. kind: the
/// command; what: the study, the task; may be empty.
inline std::string page_title(const std::string& kind, const std::string& what, const std::string& folder) {
  namespace fs = std::filesystem;
  const std::string name = (fs::path(folder) / ".").lexically_normal().parent_path().filename().string();
  const bool told = name.empty() || name == "." || name == what || name == kind;
  return kind + (what.empty() ? "" : " " + what) + (told ? "" : " (" + name + ")");
}

}  // namespace armtune::internal::report
