#pragma once
// The end of a command: its verdict on the screen and as exit code.

#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::cli {

/// Prints the verdict as the last thing on the screen. Returns kDone if it passed, else kChecksFailed.
int conclude(const SimulationVerdict& verdict);

}  // namespace armtune::internal::cli
