#pragma once
// Prints the results of `armtune validate`: how the log was read, a table of the joints, likely causes,
// findings about the log, the thresholds and, last, the verdict.

#include "tuner/validation/session/validate_session.hpp"

namespace armtune::internal::cli {

void print_validation(const ValidateSettings& settings, const ValidateOutcome& outcome);

}  // namespace armtune::internal::cli
