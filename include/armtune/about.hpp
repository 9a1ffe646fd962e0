#pragma once
// The version of armtune and of the libraries that it uses, and the names of the data files bundled with it.

#include <string>
#include <utility>
#include <vector>

namespace armtune {

/// Returns pairs (name, version). The first pair is that of armtune, the others are those of all libraries in
/// use.
std::vector<std::pair<std::string, std::string>> versions();

/// Returns the names of the bundled files of one kind. folder: "robots", "scenarios", "gains", "studies",
/// "tasks" (for plan) or "theta" (dynamic parameters of arms). Throws InputError for any other folder.
std::vector<std::string> bundled(const std::string& folder);

}  // namespace armtune
