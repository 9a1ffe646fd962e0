#pragma once
// The program, for mains that add to it (core/control/laws/controller_kind.hpp).

namespace armtune::internal::cli {

/// armtune with these arguments, to its exit code (tuner/cli/commands.hpp). Starts the process anew where its
/// mathematical functions are to be those of every processor, so to be called first, after
/// register_controller. Throws nothing.
int run(int argc, char** argv);

}  // namespace armtune::internal::cli
