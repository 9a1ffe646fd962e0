#include "sim/plant/stepper.hpp"

#include "armtune/error.hpp"

namespace armtune::internal {

Stepper stepper_from_name(const std::string& text) {
  for (const Stepper stepper : kSteppers) {
    if (text == name(stepper)) return stepper;
  }
  const std::string limit = "midpoint, semi_implicit_euler, rk4 or reference";
  throw InputError(InputPlace{.key = "stepper"}, "'" + text + "' is not known; use " + limit)
      .with_value(text, limit);
}

}  // namespace armtune::internal
