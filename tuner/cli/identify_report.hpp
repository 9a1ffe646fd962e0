#pragma once
// What `armtune identify` prints: base parameters, what is left unexplained joint by joint, what to look at,
// and which files there are.

#include "tuner/identification/session/identify_session.hpp"

namespace armtune::internal::cli {

void print_identification(const IdentifySettings& settings, const IdentifyOutcome& outcome);

}  // namespace armtune::internal::cli
