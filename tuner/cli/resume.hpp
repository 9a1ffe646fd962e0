#pragma once
// --resume FOLDER: resumes a run where it was killed, with the arguments that it was begun with.

#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/session/journalled_run.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds --out, --resume, --workers and --rollout-deadline, of a run that can be resumed. out_help: what
/// --help says of --out.
void add_run_options(CLI::App& command, const std::string& out_help, RunPlace& place, int& workers,
                     double& deadline);

/// The words of a command line, the program's name first. With --resume: the words that the folder's run was
/// begun with, then --resume with that folder, then what may differ between the two (--workers); the working
/// folder becomes the one that run was begun in, or stays, with a warning, if that is gone. Throws InputError
/// if the folder holds no journal or one of another command, or if further words were given.
std::vector<std::string> resumed_arguments(std::vector<std::string> words);

/// Returns a word as a shell takes it for one.
std::string shell_word(const std::string& word);

/// The words of a command line as a shell takes them, with armtune in place of the program's path.
std::string quoted_command(const std::vector<std::string>& words);

/// The command that makes a run again where its --out folder is not there yet, quoted for a shell: the words
/// of its command line, of a resumed run those it was begun with.
std::string repeating_command(std::vector<std::string> words);

/// What a session is given: this program's stop flag, and its command line without what may differ.
SessionContext session_context();

/// Calls `load`, which reads the inputs of a run, and returns what it gives. If a resumed run cannot read
/// them, the error says where their copies are.
template <class Load>
auto load_inputs(const RunPlace& place, const Load& load) {
  try {
    return load();
  } catch (const InputError& error) {
    if (!place.resume) throw;
    throw InputError(error.what() + where_copies_are(place.folder));
  }
}

}  // namespace armtune::internal::cli
