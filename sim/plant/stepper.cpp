#include "sim/plant/stepper.hpp"

#include "core/common/error.hpp"

namespace armtune {

Stepper stepper_from_name(const std::string& text) {
  for (const Stepper stepper :
       {Stepper::kMidpoint, Stepper::kSemiImplicitEuler, Stepper::kRungeKutta4, Stepper::kReference}) {
    if (text == name(stepper)) return stepper;
  }
  throw InputError("stepper '" + text +
                   "' is not known; use midpoint, semi_implicit_euler, rk4 or reference");
}

}  // namespace armtune
