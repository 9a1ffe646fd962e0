#pragma once
// Does the work of `armtune excite`. It designs a trajectory from whose log an arm's parameters can be
// identified, or reads a given trajectory from a file. It then simulates an arm that follows the trajectory,
// and writes the logs that the arm's sensors would record.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

struct ExciteSettings {
  std::string folder;  ///< not empty
  std::shared_ptr<const RobotModel> model;
  std::vector<Scenario> scenarios;  ///< one log is simulated in each; the arms have the model's joints
  std::string trajectory;           ///< file with a given trajectory; empty: one is designed
  ExcitationOptions design;         ///< options of the design; the session sets their `progress`
  ExcitationLogOptions log;
  std::vector<std::string> cell_files;  ///< files of waypoints from which the cell of the robot file was read
};

struct ExciteOutcome {
  Ending ending = Ending::kInterrupted;
  Excitation excitation;
  ExcitationUse use;
  /// Smallest distances along the trajectory; none if they are not checked. Valid as long as the settings'
  /// model.
  LeastClearances nearest;
  std::string contact;  ///< sentences that say which distances were checked, and which were not
  std::optional<ExcitationDesign> design;  ///< none if the trajectory was given
  std::vector<std::string> files;          ///< names of the files in the folder
};

/// Receives the progress of an ExciteSession.
class ExciteObserver : public SessionObserver {
 public:
  /// Called when the trajectory has been written.
  virtual void designed(const ExciteOutcome& /*so_far*/) {}
  /// Called when a log of the trajectory has been written.
  virtual void logged(const Scenario& /*scenario*/, const ExcitationLog& /*log*/) {}
};

class ExciteSession {
 public:
  /// The observer must outlive the session.
  ExciteSession(ExciteSettings settings, SessionContext context, ExciteObserver& observer);

  /// Runs the session. May be called only once. Throws InputError if the folder is used already or the
  /// trajectory does not fit the arm; FailedError if a file cannot be written.
  ExciteOutcome run();

 private:
  void find_trajectory();
  void write_trajectory();
  /// Returns false if the simulation was interrupted.
  bool write_log(const Scenario& scenario);
  /// Writes run.json. seconds: wall time of the run.
  void write_record(double seconds);

  ExciteSettings settings_;
  SessionContext context_;
  ExciteObserver& observer_;
  ExciteOutcome outcome_;
};

}  // namespace armtune::internal
