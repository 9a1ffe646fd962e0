#pragma once
// What a run is, so that a resumed one is known to be the same.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

struct RunHeader {
  /// Name of the identity's entry that is the hash of the program itself.
  static constexpr const char* kProgram = "program";

  std::vector<std::string> arguments;  ///< of the command line: the command and what makes its result
  std::string working_folder;          ///< where relative paths of the arguments begin
  /// Name and value of everything the results depend on; values may have several lines.
  std::vector<std::pair<std::string, std::string>> identity;
};

/// Returns what differs, for a person: "seed was 1, is 2; study was 'max_evaluations: 12', is ...". Empty if
/// nothing does. copy_of: finds a copy of what had this value (of a file: its hash), to be named as well.
std::string differences(
    const RunHeader& was, const RunHeader& is,
    const std::function<std::optional<std::string>(const std::string& value)>& copy_of = {});

}  // namespace armtune::internal
