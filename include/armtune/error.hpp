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

/// The place of an error in the input. Members that are not known are empty or 0. If there is no file, the
/// input was passed to a function, and `key` is the name of the argument.
struct InputPlace {
  std::string file = {};  ///< path as the user gave it, or as it stands in a file of the user
  long line = 0;          ///< counted from 1
  /// In YAML a key path such as "targets/1/center", in CSV the name of the column. In a URDF the name of a
  /// link or joint with its property, such as "elbow_joint/effort". If a robot YAML gives a value that does
  /// not fit its URDF, the file is the URDF and the key is that of the YAML, such as "hold/elbow_joint".
  std::string key = {};
};

/// What is wrong with a part of the input. Members that are not known are empty.
struct InputFault {
  std::string problem;     ///< what is wrong, as the first part of a sentence, such as "7 is out of range"
  std::string value = {};  ///< see InputError::value()
  std::string limit = {};  ///< see InputError::limit()
};

/// An input that cannot be used as it is: a file that cannot be read, a value outside its limits, an unknown
/// name.
class InputError : public Error {
 public:
  using Error::Error;
  /// what() is "FILE:LINE: PROBLEM", or "FILE: PROBLEM" if the line is not known. If the place has a key but
  /// no file, what() is "KEY: PROBLEM".
  InputError(InputPlace place, const std::string& problem);
  /// what() is "FILE:LINE: PROBLEM; expected LIMIT", with the place as above. It ends after PROBLEM if the
  /// limit is empty.
  InputError(InputPlace place, InputFault fault);

  /// Returns this error with more text at the end of what().
  InputError with(const std::string& more) const;
  /// Returns this error with another value and limit. what() stays the same.
  InputError with_value(std::string value, std::string limit = {}) const;

  /// Returns the place of the error. It is empty if the error is not in a file.
  const InputPlace& place() const noexcept { return fields_->place; }
  /// Returns the value that is refused: a number or text as it stands in the input, without quotes, or a
  /// wrong number of entries. It is empty if it is not known, or if no single value is wrong.
  const std::string& value() const noexcept { return fields_->value; }
  /// Returns what is accepted instead, such as "0 to 5.5", "above zero" or "one of: a, b, c". It is empty if
  /// it is not known.
  const std::string& limit() const noexcept { return fields_->limit; }

 private:
  struct Fields {
    InputPlace place = {};
    std::string value = {};
    std::string limit = {};
  };
  std::shared_ptr<const Fields> fields_ = std::make_shared<const Fields>();
};

/// A failure during work that started with valid input, such as writing to a full disk. Results that were
/// finished before the failure are kept.
class FailedError : public Error {
 public:
  using Error::Error;
};

}  // namespace armtune
