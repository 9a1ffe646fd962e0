#pragma once
// The end of a command: prints its verdict and turns it into an exit code.

#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::cli {

/// Prints the verdict as the last text on the screen. Returns kDone if it passed, else kChecksFailed.
int conclude(const SimulationVerdict& verdict);

}  // namespace armtune::internal::cli
