#pragma once
// The program as a function, for a main() that adds controllers to it (see
// core/control/laws/controller_kind.hpp).

namespace armtune::internal::cli {

/// Runs armtune with these arguments and returns its exit code (tuner/cli/commands.hpp). It may restart the
/// process so that mathematical functions give the same results on every processor. Therefore call it first
/// in main, after register_controller. Does not throw.
int run(int argc, char** argv);

}  // namespace armtune::internal::cli
