#pragma once
// A run that identifies an arm from logs of its motion: the fit, doubts whether the logs are of that arm,
// and, where it has a folder, all of its files.

#include <memory>
#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

struct IdentifySettings {
  std::string folder;                       ///< empty: nothing is written
  std::shared_ptr<const RobotModel> model;  ///< geometry, names and prior values
  std::vector<std::string> logs;            ///< paths
  LogColumns columns;
  std::string columns_path;      ///< of the file that the columns are from; empty: of none
  bool accept = false;           ///< write the result although the logs do not fit the model
  IdentifyOptions options = {};  ///< but for its progress, which is the session's own
};

struct IdentifyOutcome {
  Ending ending = Ending::kInterrupted;
  Identification found;
  std::vector<std::string>
      doubts;  ///< why the logs may not be of this arm, one sentence without its stop each
  std::vector<std::string> files;  ///< names of those in the folder
  double seconds = 0.0;            ///< that the fit took
};

class IdentifySession {
 public:
  /// The observer outlives the session.
  IdentifySession(IdentifySettings settings, SessionContext context, SessionObserver& observer);

  /// Runs it; may be called once. Throws InputError if the folder is used or a log cannot be used;
  /// FailedError if a file cannot be written.
  IdentifyOutcome run();

 private:
  void write_files();

  IdentifySettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  IdentifyOutcome outcome_;
};

}  // namespace armtune::internal
