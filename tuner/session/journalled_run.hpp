#pragma once
// The folder of a run that can be resumed after it was killed: its lock, its journal, copies of its inputs,
// and its wall time over all of its parts.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tuner/journal/journal.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

/// Where a run's files go.
struct RunPlace {
  std::string folder;   ///< empty: nothing is written
  bool resume = false;  ///< continue the run that is there
};

inline constexpr const char* kJournal = "journal.txt";

/// Returns the path of a run's journal; where there is none, the name that it would have.
std::string journal_in(const std::string& folder);

/// Returns the header of a run's journal: the invocation, and all that the results depend on, which is
/// `identity` (of the kind of run), versions and hashes of the input files.
RunHeader run_header(const Invocation& invocation, std::vector<std::pair<std::string, std::string>> identity,
                     const std::vector<std::string>& inputs);

class JournalledRun {
 public:
  /// Begins a run in a new folder, or opens one to resume, and keeps a copy of every input (see keep_inputs).
  /// write_first: writes files that stand in a new folder before its journal, which a resumed run reads from
  /// there. Throws InputError if the folder is used, if another run writes into it, or if it holds a symbolic
  /// link or another run than the header says; of a new run nothing is left then.
  JournalledRun(RunPlace place, const RunHeader& header, const std::vector<std::string>& inputs,
                SessionObserver& observer, const std::function<void()>& write_first = {});
  /// Deletes the folder of a new run unless keep() was called.
  ~JournalledRun();
  JournalledRun(const JournalledRun&) = delete;
  JournalledRun& operator=(const JournalledRun&) = delete;

  bool resumed() const { return place_.resume; }
  Journal& journal() { return *journal_; }
  /// How the run ended, if it did: then there is nothing to resume.
  std::optional<Ending> finished() const;
  /// Whether its journal is still there, so that a run which failed can be resumed.
  bool can_resume() const;
  /// Wall time of the run, that of its earlier parts included [s].
  double seconds() const { return before_ + watch_.seconds(); }
  /// From now on the folder stays, whatever happens.
  void keep() { kept_ = true; }
  /// Everything that the run was to make is written.
  void complete(Ending ending) { journal_->complete(static_cast<int>(ending)); }

 private:
  RunPlace place_;
  FolderLock lock_;
  std::unique_ptr<Journal> journal_;
  Stopwatch watch_;
  double before_ = 0.0;  ///< [s]
  bool kept_ = false;
};

}  // namespace armtune::internal
