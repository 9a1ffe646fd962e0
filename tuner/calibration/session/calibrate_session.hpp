#pragma once
// Does the work of `armtune calibrate`. It reads logs, fits the arm to them, compares the result with the
// robot file on the held-out part, and writes it into a folder if one is given.

#include <memory>
#include <string>
#include <vector>

#include "tuner/calibration/calibrate.hpp"
#include "tuner/run/calibration_facts.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"
#include "tuner/validation/log_joints.hpp"

namespace armtune::internal {

struct CalibrateSettings {
  std::string folder;                       ///< empty: nothing is written
  std::shared_ptr<const RobotModel> model;  ///< gives the priors
  std::vector<std::string> logs;            ///< paths, each a recording of its own
  LoggedJointsOptions options;              ///< how each of them is read
  std::vector<std::string> files;           ///< that the options were read from: column map
  CalibrationPriors priors = {};
};

struct CalibrateOutcome {
  Ending ending = Ending::kInterrupted;
  Calibration found;
  CalibrationFacts facts;
  std::vector<std::string> files;  ///< names of the files in the folder
};

class CalibrateSession {
 public:
  /// The observer must outlive the session.
  CalibrateSession(CalibrateSettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session; may be called once. The ending is kChecksFailed if the calibrated arm is not better on
  /// the held-out part. Throws InputError if the folder is used already, if a log cannot be used or has no
  /// commands; FailedError if a file cannot be written.
  CalibrateOutcome run();

 private:
  std::vector<CommandedLog> read_logs();
  CommandedLog read(const std::string& path, const LoggedJointsOptions& options);
  CalibrationOptions fit_options();
  void write_files(double seconds);

  CalibrateSettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  CalibrateOutcome outcome_;
  std::vector<std::string> notes_;     ///< how the logs were read
  std::vector<std::string> findings_;  ///< what is wrong with them
  long samples_ = 0;
  double duration_ = 0.0;  ///< [s]
};

}  // namespace armtune::internal
