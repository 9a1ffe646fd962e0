#pragma once
// Does the work of `armtune identify`. It estimates theta, an arm's inertial and friction parameters, from
// logs of the arm's motion. It also looks for signs that the logs are of another arm. If a folder is given,
// it writes the results there.

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
  std::string columns_path;      ///< file that the columns were read from; empty: none
  bool accept = false;           ///< true: write the result although the logs do not fit the model
  IdentifyOptions options = {};  ///< the session sets their `progress`
};

struct IdentifyOutcome {
  Ending ending = Ending::kInterrupted;
  Identification found;
  std::vector<std::string>
      doubts;  ///< reasons why the logs may not be of this arm; one sentence each, without its full stop
  std::vector<std::string> files;  ///< names of the files in the folder
  double seconds = 0.0;            ///< time that the fit took
};

class IdentifySession {
 public:
  /// The observer must outlive the session.
  IdentifySession(IdentifySettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session. May be called only once. Throws InputError if the folder is used already or a log
  /// cannot be used; FailedError if a file cannot be written.
  IdentifyOutcome run();

 private:
  void write_files();
  void write_record() const;

  IdentifySettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  IdentifyOutcome outcome_;
};

}  // namespace armtune::internal
