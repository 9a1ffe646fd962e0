#pragma once
// Does the work of `armtune yardstick`: compares the rollouts of a finished run with the best motions that
// the arm's limits allow. It writes the comparison, and updates the report of the run.

#include <string>
#include <vector>

#include "tuner/planning/session/rollout_measures.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

struct YardstickSettings {
  std::string folder;                  ///< folder of a run, or of one of its gain sets
  std::vector<std::string> scenarios;  ///< names or files; empty: the run's own
  std::string out;                     ///< file to write; empty: FOLDER/yardstick.csv
  YardstickOptions options;            ///< gaze_threshold and clearance are those of the run's gains
};

struct YardstickOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<Measure> measures;   ///< fewer if interrupted
  std::vector<std::string> files;  ///< paths of the written files; empty if interrupted before any result
};

class YardstickSession {
 public:
  /// The observer must outlive the session.
  YardstickSession(YardstickSettings settings, SessionContext context, YardstickObserver& observer);

  /// Runs the session. May be called only once. Writes the comparison as a CSV file, and beside it a record
  /// of the same name with the ending .json. Without `out` they are yardstick.csv and yardstick.json in the
  /// folder; the run's columns.csv and its report are then updated too. Throws InputError if the folder has
  /// no rollouts or no gains, if a file of the run cannot be used, or if `out` exists already. Throws
  /// FailedError if a file cannot be written.
  YardstickOutcome run();

 private:
  std::string record_text(const std::vector<Scenario>& scenarios, const RolloutMeasures& found,
                          double seconds) const;
  void write_files(const std::vector<Scenario>& scenarios, const RolloutMeasures& found, double seconds);
  void write_report_again(const std::string& run);

  YardstickSettings settings_;
  SessionContext context_;
  YardstickObserver& observer_;
  YardstickOutcome outcome_;
};

}  // namespace armtune::internal
