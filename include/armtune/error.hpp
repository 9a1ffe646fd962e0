#pragma once
// Every exception that armtune throws is an armtune::Error. Outcomes of a simulation or a search (diverged,
// infeasible, interrupted) are no exceptions: results say so.

#include <stdexcept>
#include <string>

namespace armtune {

/// what() is one line: where (file, line or key), the value, the limit, and what to do.
class Error : public std::runtime_error {
 public:
  /// Line breaks and other control characters in the message are shown as escapes.
  explicit Error(const std::string& message);
};

/// Input cannot be used as it is: a file that cannot be read, a value outside its limit, a name that is not
/// known.
class InputError : public Error {
 public:
  using Error::Error;
};

/// Work that was begun with good input failed, such as writing a file to a full disk. What was finished by
/// then is kept.
class FailedError : public Error {
 public:
  using Error::Error;
};

}  // namespace armtune
