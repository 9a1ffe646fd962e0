#pragma once
// The program `armtune`, to be called from a program of one's own that has more controllers. Link
// armtune::cli.

namespace armtune {

/// Runs the command line and returns the exit code. To be called from main, before any thread is started.
int run_program(int argc, char** argv);

}  // namespace armtune
