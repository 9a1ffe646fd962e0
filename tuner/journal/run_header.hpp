#pragma once
// The header of a run's journal: the command line, and everything that the results depend on, such as the
// hashes of the inputs. An interrupted run can be resumed only if none of the latter has changed.

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
/// there are none. copy_of: returns the path of a copy of the file with this hash, which the text then names
/// too, or nothing.
std::string differences(
    const RunHeader& was, const RunHeader& is,
    const std::function<std::optional<std::string>(const std::string& value)>& copy_of = {});

}  // namespace armtune::internal
