#include "tuner/cli/mcap_option.hpp"

#include <CLI/CLI.hpp>

namespace armtune::internal::cli {

CLI::Option* add_mcap_option(CLI::App& command, bool& wanted) {
  return command.add_flag("--mcap", wanted,
                          "also write each simulated or planned motion as an MCAP file, which Foxglove, "
                          "PlotJuggler and Rerun open (see docs/logs.md)");
}

}  // namespace armtune::internal::cli
