#pragma once
// The command line options that allow armtune to expand xacro files of robots.

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --xacro and --xacro-argument to every command that reads robots. armtune then runs the program xacro
/// for each xacro file that it reads, and prints the exact command on standard error.
void add_xacro_options(CLI::App& app);

}  // namespace armtune::internal::cli
