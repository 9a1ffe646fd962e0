#pragma once
// The options of commands that read recordings of robots: which topics are read, and from which column or
// rate the time of a row follows.

#include <string>

#include "sim/logs/log_selection.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

struct LogArguments {
  LogSelection selection;
  std::string msg_path;
  std::string time_unit;
  double rate = 0.0;  ///< [Hz]; 0: not given
};

/// Adds --topic, --msg-path, --time, --time-unit and --rate. The arguments must outlive the command.
void add_log_options(CLI::App& command, LogArguments& args);

/// Returns what the options select.
LogSelection selection_of(const LogArguments& args);

}  // namespace armtune::internal::cli
