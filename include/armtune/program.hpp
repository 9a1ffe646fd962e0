#pragma once
// The command line program `armtune` as a function, for a program of your own that adds controllers to it.
// Link armtune::cli.

namespace armtune {

/// Runs the command line and returns the exit code. Call it first in main, before any thread is started,
/// because it may restart the process. It restarts the process if the C library would otherwise compute sin,
/// exp, ... with instructions that not every x86-64 processor has. Such variants differ in the last bit.
int run_program(int argc, char** argv);

}  // namespace armtune
