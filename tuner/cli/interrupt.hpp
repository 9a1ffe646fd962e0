#pragma once
// SIGINT, SIGTERM and SIGHUP as a flag that long work looks at. Signal handlers leave no other way than a
// global.

#include <atomic>
#include <string>
#include <vector>

namespace armtune::internal::cli {

/// True once the user asked to stop. The first signal is polite; another, half a second later
/// or more, ends the program at once.
std::atomic<bool>& stop_requested();
void catch_interrupts();
/// Of a process that another one tells when to stop.
void ignore_interrupts();

/// The words of the command line, for provenance; of a resumed run those it was begun with.
std::vector<std::string>& command_words();
/// What makes the run again, for provenance (see repeating_command).
std::string& command_line();
/// The program as typed, to name it in advice.
std::string& program_name();

/// Threads to use when the user says nothing: one per processor; one among ranks.
int default_workers();

}  // namespace armtune::internal::cli
