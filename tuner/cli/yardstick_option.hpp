#pragma once
// The option --yardstick of `armtune tune` and `armtune simulate`. At the end of the run it compares the
// rollouts with the best motions that the arm's limits allow.

#include "tuner/session/yardstick_files.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --yardstick if armtune is built with the planner. Otherwise adds nothing, and `wanted` stays false.
void add_yardstick_option(CLI::App& command, bool& wanted);

/// Returns the function that a session calls for this comparison (see Yardstick), or an empty function if
/// `wanted` is false. The function prints each result, and errors on stderr. If interrupted, it writes only
/// yardstick.csv, with the events that are finished.
Yardstick yardstick_if(bool wanted);

}  // namespace armtune::internal::cli
