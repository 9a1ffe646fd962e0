#pragma once
// The one exception type of armtune: the user's input cannot be used as it is.

#include <stdexcept>
#include <string>

#include "core/common/message_text.hpp"

namespace armtune {

/// Thrown for every kind of misuse: a file that cannot be read, a value outside its limit, an unknown name.
/// The message is one line whatever it quotes (see one_line): where (file, line or key), the value, the
/// limit, what to do. Programs end with exit code 2. Outcomes of a simulation or a search (diverged,
/// infeasible) are statuses, never exceptions.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

}  // namespace armtune
