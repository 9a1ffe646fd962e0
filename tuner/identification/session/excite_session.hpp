#pragma once
// A run that designs a trajectory which shows an arm's parameters, or takes one, and simulates logs of it.

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
  std::vector<Scenario> scenarios;  ///< of arms with the model's joints: a log of each
  std::string trajectory;           ///< file to take one from; empty: one is designed
  ExcitationOptions design;         ///< but for its progress, which is the session's own
  ExcitationLogOptions log;
};

struct ExciteOutcome {
  Ending ending = Ending::kInterrupted;
  Excitation excitation;
  ExcitationUse use;
  std::optional<ExcitationDesign> design;  ///< none of a trajectory that was given
  std::vector<std::string> files;          ///< names of those in the folder
};

/// Hears of such a run while it is under way.
class ExciteObserver : public SessionObserver {
 public:
  /// The trajectory is written.
  virtual void designed(const ExciteOutcome& /*so_far*/) {}
  /// A log of it is written.
  virtual void logged(const Scenario& /*scenario*/, const ExcitationLog& /*log*/) {}
};

class ExciteSession {
 public:
  /// The observer outlives the session.
  ExciteSession(ExciteSettings settings, SessionContext context, ExciteObserver& observer);

  /// Runs it; may be called once. Throws InputError if the folder is used or the trajectory does not fit the
  /// arm; FailedError if a file cannot be written.
  ExciteOutcome run();

 private:
  void find_trajectory();
  void write_trajectory();
  /// Returns false if it was interrupted.
  bool write_log(const Scenario& scenario);

  ExciteSettings settings_;
  SessionContext context_;
  ExciteObserver& observer_;
  ExciteOutcome outcome_;
};

}  // namespace armtune::internal
