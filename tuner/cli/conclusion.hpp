#pragma once
// The end of a command: its verdict in the run folder, on the screen, and as exit code.

#include <string>

#include "tuner/verdict/verdict.hpp"

namespace armtune::cli {

/// Writes FOLDER/verdict.yaml, which the report begins with. Nothing where the folder's name is empty.
void write_verdict(const std::string& folder, const SimulationVerdict& verdict);

/// Prints the verdict as the last thing on the screen. Returns kDone if it passed, else kChecksFailed.
int conclude(const SimulationVerdict& verdict);

}  // namespace armtune::cli
