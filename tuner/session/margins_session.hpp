#pragma once
// The work of the command `armtune margins`. It finds the stability margins of a gain set. If an output
// folder is given, it writes the margins there.

#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

struct MarginsSettings {
  std::string folder;  ///< empty: nothing is written
  std::vector<Scenario> scenarios;
  Gains gains;
  std::string gains_path;  ///< path of the gains file; empty: the gains are from no file
  MarginOptions options;   ///< its functions are set by the session
};

struct MarginsOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<Margin> margins;     ///< those that were done
  SimulationVerdict verdict;       ///< one check for each margin (add_nominal_checks); empty if interrupted
  std::vector<std::string> files;  ///< names of the files in the folder
};

class MarginsSession {
 public:
  /// The observer must outlive the session.
  MarginsSession(MarginsSettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session. May be called only once. The check of a margin fails if a loop is not stable at the
  /// nominal value of the margin. Throws InputError if the folder is not empty, and FailedError if a file
  /// cannot be written. At any time, margins.csv has the margins that are finished.
  MarginsOutcome run();

 private:
  void write_margins(const std::vector<Margin>& found) const;
  void write_results();
  void check();

  MarginsSettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  Stopwatch watch_;
  MarginsOutcome outcome_;
};

}  // namespace armtune::internal
