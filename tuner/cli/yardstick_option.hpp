#pragma once
// The option --yardstick, which compares a run at its end with the best that the arm's limits allow.

#include "tuner/session/yardstick_files.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --yardstick if armtune is built with the planner. Otherwise adds nothing, and `wanted` stays false.
void add_yardstick_option(CLI::App& command, bool& wanted);

/// Returns the function that measures the rollouts of a run and prints its findings (see Yardstick), or an
/// empty one if it is not wanted. Errors are printed on stderr. If interrupted, it writes only yardstick.csv,
/// with the events that are finished.
Yardstick yardstick_if(bool wanted);

}  // namespace armtune::internal::cli
