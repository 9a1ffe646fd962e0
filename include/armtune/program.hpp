#pragma once
// The program `armtune`, to be called from a program of one's own that has more controllers. Link
// armtune::cli.

namespace armtune {

/// Runs the command line and returns the exit code. To be called first in main, before any thread is started:
/// where the C library would compute with other variants of sin, exp, ... than those of every x86-64
/// processor, it starts the process anew.
int run_program(int argc, char** argv);

}  // namespace armtune
