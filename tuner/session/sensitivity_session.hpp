#pragma once
// The work of the command `armtune sensitivity`. It computes how much each gain matters in a finished run. If
// an output folder is given, it writes the results and a smaller study there.

#include <optional>
#include <string>
#include <vector>

#include "tuner/run/hashed_table.hpp"
#include "tuner/sensitivity/sensitivity.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::internal {

struct SensitivitySettings {
  std::string run;     ///< folder of the finished run
  Study study;         ///< study of the run
  std::string folder;  ///< empty: nothing is written
  int workers = 1;
  double deadline = 0.0;  ///< for one rollout, wall clock [s]; 0: derived from its duration
};

struct SensitivityOutcome {
  Ending ending = Ending::kInterrupted;
  Sensitivity sensitivity;         ///< empty if interrupted
  std::vector<std::string> files;  ///< names of the files in the folder
};

class SensitivitySession {
 public:
  /// The observer must outlive the session.
  SensitivitySession(SensitivitySettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session. May be called only once. Returns nothing in an MPI rank other than 0, which only
  /// simulates for rank 0. If interrupted, writes nothing. Throws InputError if a file of the run cannot be
  /// used or the folder is not empty, and FailedError if a file cannot be written.
  std::optional<SensitivityOutcome> run(RankGroup& ranks);

 private:
  std::string gains_path() const;
  void write_files(const HashedTable& evaluations, int workers);

  SensitivitySettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  Stopwatch watch_;
  SensitivityOutcome outcome_;
};

}  // namespace armtune::internal
