#pragma once
// Ends a command: prints the verdict, which is the result of all simulation checks on the gains, and converts
// it to an exit code.

#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::cli {

/// Prints the verdict as the last text on the screen. Returns kDone if it passed, else kChecksFailed.
int conclude(const SimulationVerdict& verdict);

}  // namespace armtune::internal::cli
