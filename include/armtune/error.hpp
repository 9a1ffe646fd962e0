#pragma once
// The exceptions of armtune, all of which derive from armtune::Error; the standard library's own, such as
// std::bad_alloc, can pass through it. A simulation that diverges, a search that finds nothing feasible and a
// run that is interrupted throw nothing: their results say so.

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
