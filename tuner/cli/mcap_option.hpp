#pragma once
// The option --mcap of `armtune simulate`, `compare`, `tune` and `plan`, which also writes motions as MCAP
// files.

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// Declares the option and returns it. If --out has no default in a command, the command must declare that
/// --mcap needs --out.
CLI::Option* add_mcap_option(CLI::App& command, bool& wanted);

}  // namespace armtune::internal::cli
