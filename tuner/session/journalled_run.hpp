#pragma once
// Manages the folder of a run that can be resumed after it was killed. It locks the folder, and keeps a
// journal of everything that was completed. It also keeps copies of the input files, and adds up the wall
// time of all parts of a run that was resumed.

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

/// The folder into which a run writes its files.
struct RunPlace {
  std::string folder;   ///< empty: nothing is written
  bool resume = false;  ///< true: continue the run in this folder
};

inline constexpr const char* kJournal = "journal.txt";

/// Returns the path of a run's journal, or the path that it would have if there is none.
std::string journal_in(const std::string& folder);

/// Returns the header of a run's journal: the invocation, and everything on which the results depend. The
/// command passes the part that is specific to it as `identity`. This function adds the versions and the
/// hashes of the input files.
RunHeader run_header(const Invocation& invocation, std::vector<std::pair<std::string, std::string>> identity,
                     const std::vector<std::string>& inputs);

class JournalledRun {
 public:
  /// Begins a run in a new folder, or opens a run to resume it. Keeps a copy of every input (keep_inputs).
  /// write_first: called for a new run before the journal is written; writes files that a resumed run reads
  /// from the folder. Throws InputError if a new run's folder is not empty, or if another process writes into
  /// the folder. For a run to resume, also throws InputError if the folder contains a symbolic link, or if
  /// the header in its journal differs. If the constructor fails for a new run, it removes all that it has
  /// written.
  JournalledRun(RunPlace place, const RunHeader& header, const std::vector<std::string>& inputs,
                SessionObserver& observer, const std::function<void()>& write_first = {});
  /// Deletes the folder of a new run unless keep() was called.
  ~JournalledRun();
  JournalledRun(const JournalledRun&) = delete;
  JournalledRun& operator=(const JournalledRun&) = delete;

  bool resumed() const { return place_.resume; }
  Journal& journal() { return *journal_; }
  /// Returns how the run ended, or nothing if it has not ended. A run that has ended cannot be resumed.
  std::optional<Ending> finished() const;
  /// True if the journal still exists, so that a run that failed can be resumed.
  bool can_resume() const;
  /// Returns the wall time of the run, including its earlier parts [s].
  double seconds() const { return before_ + watch_.seconds(); }
  /// Keeps the folder from now on, even if the run fails.
  void keep() { kept_ = true; }
  /// Marks the run as complete. Call it when all files are written.
  void complete(Ending ending) { journal_->complete(static_cast<int>(ending)); }

 private:
  RunPlace place_;
  FolderLock lock_;
  std::unique_ptr<Journal> journal_;
  Stopwatch watch_;
  double before_ = 0.0;  ///< wall time of the earlier parts [s]
  bool kept_ = false;
};

}  // namespace armtune::internal
