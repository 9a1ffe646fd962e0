#pragma once
// The exceptions of armtune, all derived from armtune::Error. Exceptions of the standard library, such as
// std::bad_alloc, can pass through armtune. A simulation that diverges, a search without a feasible point
// and an interrupted run are not errors: the returned result reports them.

#include <stdexcept>
#include <string>

namespace armtune {

/// The base class of armtune's exceptions. what() is one line: where (file, line or key), the value, the
/// limit, and what to do.
class Error : public std::runtime_error {
 public:
  /// Shows line breaks and other control characters in the message as escapes.
  explicit Error(const std::string& message);
};

/// An input that cannot be used as it is: a file that cannot be read, a value outside its limits, an unknown
/// name.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A failure during work that started with valid input, such as writing to a full disk. Results that were
/// finished before the failure are kept.
class FailedError : public Error {
 public:
  using Error::Error;
};

}  // namespace armtune
