#pragma once
// Holds global data of the program. SIGINT, SIGTERM and SIGHUP set a stop flag, which long computations poll;
// it is global because signal handlers can only reach globals. The command line is stored here too, so that
// results can record how they were made (their provenance).

#include <atomic>
#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Returns the flag that is true once the user asked to stop. The first signal sets it. Another signal, half
/// a second later or more, ends the program at once.
std::atomic<bool>& stop_requested();
void catch_interrupts();
/// Ignores these signals. Called in a process that another process stops, such as a rank other than 0.
void ignore_interrupts();

/// Returns the words of the command line, for provenance. For a resumed run see resumed_arguments.
std::vector<std::string>& command_words();
/// Returns the command that repeats the run, for provenance (see repeating_command).
std::string& command_line();
/// Returns the program's name as the user typed it, for advice in messages.
std::string& program_name();

/// Returns the number of threads to use by default: one per processor, or one among ranks.
int default_workers();

}  // namespace armtune::internal::cli
