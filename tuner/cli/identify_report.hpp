#pragma once
// Prints the results of `armtune identify`: the identified base parameters, the part of each joint's torque
// that the model does not explain, warnings, and the files written.

#include "tuner/identification/session/identify_session.hpp"

namespace armtune::internal::cli {

void print_identification(const IdentifySettings& settings, const IdentifyOutcome& outcome);

}  // namespace armtune::internal::cli
