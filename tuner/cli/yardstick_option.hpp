#pragma once
// --yardstick: what the arm's limits would allow, at the end of a run.

#include "tuner/session/yardstick_files.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --yardstick where armtune was built with the planner; elsewhere nothing, and `wanted` stays false.
void add_yardstick_option(CLI::App& command, bool& wanted);

/// Returns what measures the rollouts of a run (see Yardstick), if it is wanted, and prints what it finds.
/// What goes wrong is told on stderr. Nothing is left of an interrupted one but yardstick.csv with what is
/// finished.
Yardstick yardstick_if(bool wanted);

}  // namespace armtune::internal::cli
