#include "armtune/about.hpp"

#include "sim/scenario/data_files.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune {

std::vector<std::pair<std::string, std::string>> versions() {
  return internal::versions();
}

std::vector<std::string> bundled(const std::string& folder) {
  return internal::bundled_names(folder);
}

}  // namespace armtune
