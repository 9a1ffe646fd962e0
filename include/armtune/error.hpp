#pragma once
// The exceptions of armtune, all derived from armtune::Error. Exceptions of the standard library, such as
// std::bad_alloc, can pass through armtune. A simulation that diverges, a search without a feasible point
// and an interrupted run are not errors: the returned result reports them.

#include <memory>
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

/// The place of an error in the input. Members that are not known are empty or 0.
struct InputPlace {
  std::string file = {};  ///< path as given by the user, or in a file of the user
  long line = 0;          ///< counted from 1
  std::string key = {};   ///< in YAML a key path such as "targets/1/center", in CSV the name of the column
};

/// An input that cannot be used as it is: a file that cannot be read, a value outside its limits, an unknown
/// name.
class InputError : public Error {
 public:
  using Error::Error;
  /// what() is "FILE:LINE: PROBLEM", or "FILE: PROBLEM" if the line is not known.
  InputError(InputPlace place, const std::string& problem);

  /// Returns this error with more text at the end of what().
  InputError with(const std::string& more) const;

  /// Returns the place of the error. It is empty if the error is not in a file.
  const InputPlace& place() const noexcept { return *place_; }

 private:
  std::shared_ptr<const InputPlace> place_ = std::make_shared<const InputPlace>();
};

/// A failure during work that started with valid input, such as writing to a full disk. Results that were
/// finished before the failure are kept.
class FailedError : public Error {
 public:
  using Error::Error;
};

}  // namespace armtune
