#pragma once
// The identity of a run. A run can be resumed only if it has not changed.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

struct RunHeader {
  /// Name of the entry of `identity` that holds the hash of the program itself.
  static constexpr const char* kProgram = "program";

  std::vector<std::string> arguments;  ///< of the command line: the command and what its result depends on
  std::string working_folder;          ///< folder that relative paths in the arguments refer to
  /// Name and value of everything that the results depend on. Values may have several lines.
  std::vector<std::pair<std::string, std::string>> identity;
};

/// Returns the differences in words: "seed was 1, is 2; study was 'max_evaluations: 12', is ...". Empty if
/// there are none. copy_of: returns a copy of the file that had this hash, to be named too, or nothing.
std::string differences(
    const RunHeader& was, const RunHeader& is,
    const std::function<std::optional<std::string>(const std::string& value)>& copy_of = {});

}  // namespace armtune::internal
