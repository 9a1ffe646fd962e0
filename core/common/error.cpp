#include "armtune/error.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/common/message_text.hpp"

namespace armtune {

Error::Error(const std::string& message) : std::runtime_error(internal::one_line(message)) {}

InputError::InputError(InputPlace place, const std::string& problem)
    : Error(place.line > 0 ? fmt::format("{}:{}: {}", place.file, place.line, problem)
                           : fmt::format("{}: {}", place.file, problem)),
      place_(std::make_shared<const InputPlace>(std::move(place))) {}

InputError InputError::with(const std::string& more) const {
  InputError longer(what() + more);
  longer.place_ = place_;
  return longer;
}

}  // namespace armtune
