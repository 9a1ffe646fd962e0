#pragma once
// Prints the results of `armtune calibrate`: how the logs were read, the parameters that they tell, what they
// do not tell, the error on the held-out part, what limits the result and, last, the result as a sentence.

#include "tuner/calibration/session/calibrate_session.hpp"

namespace armtune::internal::cli {

void print_calibration(const CalibrateSettings& settings, const CalibrateOutcome& outcome);

}  // namespace armtune::internal::cli
