#pragma once
// The command line program `armtune` as a function, for a program of your own that adds controllers to it.
// Link armtune::cli.

namespace armtune {

/// Runs the command line and returns the exit code. Call it first in main, before any thread is started: it
/// may restart the process. It does so if the C library would otherwise compute sin, exp, ... with variants
/// that not every x86-64 processor has, since these differ in the last bit.
int run_program(int argc, char** argv);

}  // namespace armtune
