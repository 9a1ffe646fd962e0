#pragma once
// The version of armtune, and the names of its bundled data.

#include <string>
#include <utility>
#include <vector>

namespace armtune {

/// (name, version) of armtune and of every library in use, armtune first.
std::vector<std::pair<std::string, std::string>> versions();

/// Names of what is bundled: folder is one of robots, scenarios, gains, studies, tasks, theta. Throws
/// InputError.
std::vector<std::string> bundled(const std::string& folder);

}  // namespace armtune
