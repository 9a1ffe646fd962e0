#pragma once
// Holds global data of the program. SIGINT, SIGTERM and SIGHUP set a stop flag, which long computations poll;
// it is global because signal handlers can only reach globals. The command line is stored here too, so that
// results can record how they were made (their provenance).

#include <atomic>
#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Returns the flag that is true once the user asked to stop. The first signal sets it. A further signal ends
/// the program at once if it comes more than half a second after the first one.
std::atomic<bool>& stop_requested();
/// Makes SIGINT, SIGTERM and SIGHUP set this flag. SIGHUP stays ignored if it was ignored before (nohup).
void catch_interrupts();
/// Ignores SIGINT, SIGTERM and SIGHUP from now on. Called in a process that another process stops, such as an
/// MPI rank other than 0, and in a process that has nothing left to save.
void ignore_interrupts();

/// Returns the words of the command line, for provenance. For a resumed run see resumed_arguments.
std::vector<std::string>& command_words();
/// Returns the command that repeats the run, for provenance (see repeating_command).
std::string& command_line();
/// Returns the program's name as the user typed it, for advice in messages.
std::string& program_name();

/// Returns the default number of threads: one per processor, or one if the run has several MPI ranks.
int default_workers();

}  // namespace armtune::internal::cli
