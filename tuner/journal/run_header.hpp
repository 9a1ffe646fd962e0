#pragma once
// Describes the header of a run's journal. It holds the command line, and everything that the results depend
// on, such as the hashes of the inputs. An interrupted run can be resumed only if nothing that its results
// depend on has changed.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

struct RunHeader {
  /// Name of the entry of `identity` that holds the hash of the program itself.
  static constexpr const char* kProgram = "program";

  std::vector<std::string> arguments;  ///< the command, and its arguments that change results
  std::string working_folder;          ///< folder that relative paths in the arguments refer to
  /// Name and value of everything that the results depend on. Values may have several lines.
  std::vector<std::pair<std::string, std::string>> identity;
};

/// Returns the differences in words, such as "seed was '1', is '2'; study was 'max_evaluations: 12', is ...".
/// The text is empty if there are none. copy_of: if `value` is the hash of a file and a copy of that file
/// exists, returns the path of the copy, which the text then names; else returns nothing.
std::string differences(
    const RunHeader& was, const RunHeader& is,
    const std::function<std::optional<std::string>(const std::string& value)>& copy_of = {});

}  // namespace armtune::internal
