#pragma once
// Does the work of `armtune validate`. It reads a log, compares it with an unfitted robot model, and writes
// the result into a folder if one is given.

#include <memory>
#include <string>
#include <vector>

#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"
#include "tuner/validation/log_validation.hpp"

namespace armtune::internal {

struct ValidateSettings {
  std::string folder;                       ///< empty: nothing is written
  std::shared_ptr<const RobotModel> model;  ///< compared with the log as it is
  std::vector<std::string> logs;            ///< paths: one log, or text files that are read side by side
  LoggedJointsOptions options;
  ValidationThresholds thresholds;
  std::vector<std::string> files;  ///< that the options were read from: column map, gains
};

struct ValidateOutcome {
  Ending ending = Ending::kInterrupted;
  LoggedJoints logged;
  LogValidation found;
  std::vector<std::string> files;  ///< names of the files in the folder
};

class ValidateSession {
 public:
  /// The observer must outlive the session.
  ValidateSession(ValidateSettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session; may be called once. The ending is kChecksFailed if the model does not match. Throws
  /// InputError if the folder is used already or the log cannot be used; FailedError if a file cannot be
  /// written.
  ValidateOutcome run();

 private:
  void write_files(double seconds);

  ValidateSettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  ValidateOutcome outcome_;
};

}  // namespace armtune::internal
