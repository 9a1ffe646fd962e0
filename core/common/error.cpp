#include "armtune/error.hpp"

#include "core/common/message_text.hpp"

namespace armtune {

Error::Error(const std::string& message) : std::runtime_error(internal::one_line(message)) {}

}  // namespace armtune
