#include "armtune/error.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/common/message_text.hpp"

namespace armtune {

namespace {

std::string message_of(const InputPlace& place, const std::string& problem) {
  if (place.line > 0) return fmt::format("{}:{}: {}", place.file, place.line, problem);
  return fmt::format("{}: {}", place.file.empty() ? place.key : place.file, problem);
}

std::string sentence_of(const InputFault& fault) {
  return fault.limit.empty() ? fault.problem : fmt::format("{}; expected {}", fault.problem, fault.limit);
}

}  // namespace

Error::Error(const std::string& message) : std::runtime_error(internal::one_line(message)) {}

InputError::InputError(InputPlace place, const std::string& problem)
    : Error(message_of(place, problem)),
      fields_(std::make_shared<const Fields>(Fields{.place = std::move(place)})) {}

InputError::InputError(InputPlace place, InputFault fault)
    : Error(message_of(place, sentence_of(fault))),
      fields_(std::make_shared<const Fields>(
          Fields{std::move(place), std::move(fault.value), std::move(fault.limit)})) {}

InputError InputError::with(const std::string& more) const {
  InputError longer(what() + more);
  longer.fields_ = fields_;
  return longer;
}

InputError InputError::with_value(std::string value, std::string limit) const {
  InputError same(*this);
  same.fields_ = std::make_shared<const Fields>(Fields{place(), std::move(value), std::move(limit)});
  return same;
}

}  // namespace armtune
