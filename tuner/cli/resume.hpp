#pragma once
// --resume FOLDER: a run goes on where it was killed, with the arguments it was begun with.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/common/error.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/study/study.hpp"

namespace armtune::cli {

/// The words of a command line, the program's name first. With --resume: the words that the folder's run was
/// begun with, then --resume with that folder, then what may differ between the two (--workers); the working
/// folder becomes the one that run was begun in, or stays, with a warning, if that is gone. Throws InputError
/// if the folder holds no journal or one of another command, or if further words were given.
std::vector<std::string> resumed_arguments(std::vector<std::string> words);

/// The words of a command line as a shell takes them, with armtune in place of the program's path.
std::string quoted_command(const std::vector<std::string>& words);

/// The command that makes a run again where its --out folder is not there yet, quoted for a shell: the words
/// of its command line, of a resumed run those it was begun with.
std::string repeating_command(std::vector<std::string> words);

/// All that a study's results depend on but the files its scenarios are made from, and those files.
std::vector<std::pair<std::string, std::string>> identity_of(const Study& study);
std::vector<std::string> inputs_of(const Study& study);

/// Header of a new run's journal: this command line without --out and what may differ, and all that the
/// results depend on: `identity` (of the command), versions, hashes of the input files.
RunHeader run_header(std::vector<std::pair<std::string, std::string>> identity,
                     const std::vector<std::string>& inputs);

/// Begins the journal in `folder`, or opens it to go on and says what it found, and keeps a copy of every
/// input (see keep_inputs). `resume`: the folder given there, or empty. Throws InputError, of a resumed run
/// also for a symbolic link in its folder; of a new one nothing is left then.
std::unique_ptr<Journal> open_journal(const std::string& folder, const std::string& resume,
                                      const RunHeader& header, const std::vector<std::string>& inputs);

/// Calls `load`, which reads the inputs of a run, and returns what it gives. If a resumed run cannot read
/// them, the error says where their copies are. `resume`: as above.
template <class Load>
auto load_inputs(const std::string& resume, const Load& load) {
  try {
    return load();
  } catch (const InputError& error) {
    if (resume.empty()) throw;
    throw InputError(error.what() + where_copies_are(resume));
  }
}

/// Says on stderr that a run which failed can go on, and how.
void tell_how_to_go_on(const std::string& command, const std::string& folder);

/// Takes away the folder of a new run that ended before anything was finished.
void discard_run(const std::string& folder);

}  // namespace armtune::cli
