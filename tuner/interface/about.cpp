#include "armtune/about.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune {

std::vector<std::pair<std::string, std::string>> versions() {
  return internal::versions();
}

std::vector<std::string> bundled(const std::string& folder) {
  const std::vector<std::string> folders = {"robots", "scenarios", "gains", "studies", "tasks", "theta"};
  if (std::find(folders.begin(), folders.end(), folder) == folders.end()) {
    const std::string names = fmt::format("{}", fmt::join(folders, ", "));
    throw InputError(InputPlace{.key = "folder"},
                     fmt::format("{}; it must be one of {}", internal::shown(folder), names))
        .with_value(folder, fmt::format("one of: {}", names));
  }
  return internal::bundled_names(folder);
}

}  // namespace armtune
