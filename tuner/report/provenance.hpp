#pragma once
// run.yaml read back.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal::report {

/// Every value as text, in the order of the file; keys as paths, "versions/eigen". Throws InputError.
std::vector<std::pair<std::string, std::string>> read_provenance(const std::string& path);

}  // namespace armtune::internal::report
