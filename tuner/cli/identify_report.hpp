#pragma once
// The output of `armtune identify`: the base parameters, the torque of each joint that the model does not
// explain, warnings, and the files written.

#include "tuner/identification/session/identify_session.hpp"

namespace armtune::internal::cli {

void print_identification(const IdentifySettings& settings, const IdentifyOutcome& outcome);

}  // namespace armtune::internal::cli
