#pragma once
// A flag that is set by SIGINT, SIGTERM and SIGHUP and that long work polls, with other global data of the
// program. Signal handlers can only reach globals.

#include <atomic>
#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Returns the flag that is true once the user asked to stop. The first signal sets it. Another signal, half
/// a second later or more, ends the program at once.
std::atomic<bool>& stop_requested();
void catch_interrupts();
/// Ignores the signals, in a process that another process tells when to stop.
void ignore_interrupts();

/// Returns the words of the command line, for provenance. A resumed run has the words it was begun with.
std::vector<std::string>& command_words();
/// Returns the command that makes the run again, for provenance (see repeating_command).
std::string& command_line();
/// Returns the program's name as the user typed it, for advice in messages.
std::string& program_name();

/// Returns the number of threads to use by default: one per processor, or one among ranks.
int default_workers();

}  // namespace armtune::internal::cli
