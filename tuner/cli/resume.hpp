#pragma once
// The option --resume FOLDER. It resumes a run that was killed or interrupted, with the command line that the
// run was started with.

#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/session/journalled_run.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --out, --resume, --workers and --rollout-deadline to a command whose runs can be resumed. out_help:
/// help text of --out. out_default: words for its default.
void add_run_options(CLI::App& command, const std::string& out_help, const std::string& out_default,
                     RunPlace& place, int& workers, double& deadline);

/// Returns the words of the command line to run, beginning with the program's name. Without --resume they are
/// `words`. With --resume they are the words that the folder's run was started with, then --resume and the
/// folder, then those options in `words` that may change (--workers, --rollout-deadline, --live). The current
/// folder is changed to the folder in which the run was started. If that folder does not exist any more, a
/// warning is printed instead. Throws InputError if the folder holds no journal, if its run was started by
/// another command or through the library, or if `words` contains any other option or argument.
std::vector<std::string> resumed_arguments(std::vector<std::string> words);

/// Returns the command that repeats a run from its start, quoted for a shell. It works if the --out folder of
/// the command does not exist yet. words: result of resumed_arguments.
std::string repeating_command(std::vector<std::string> words);

/// Returns the data that every session (the work of one command) gets: the stop flag, and the command line
/// without --out, --workers and --rollout-deadline.
SessionContext session_context();

/// Calls `load`, which reads the inputs of a run, and returns its result. If a resumed run cannot read them,
/// the error message also names where their copies are.
template <class Load>
auto load_inputs(const RunPlace& place, const Load& load) {
  try {
    return load();
  } catch (const InputError& error) {
    if (!place.resume) throw;
    throw error.with(where_copies_are(place.folder));
  }
}

}  // namespace armtune::internal::cli
