#pragma once
// A run that simulates scenarios under one gain set: rollouts, endurance where it is wanted, checks, and,
// where it has a folder, all of its files.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tuner/endurance/endurance.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"
#include "tuner/session/yardstick_files.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// A gain set that fits the robot of every scenario that it is simulated in.
struct GainsToSimulate {
  std::string name;                                ///< of the set, such as "published"
  std::string path;                                ///< of its file; empty: of none
  std::function<Gains(const Scenario&)> gains_of;  ///< for the scenario's robot
};

/// How gain sets are simulated.
struct RolloutSettings {
  std::string folder;  ///< empty: nothing is written
  std::vector<Scenario> scenarios;
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;
  int workers = 1;           ///< threads
  int record_every = 5;      ///< control periods per row of the recordings
  double deadline = 0.0;     ///< of one scenario, wall clock [s]; 0: by its duration
  double endurance = 0.0;    ///< simulated minutes that every scenario is extended to; 0: none is
  Yardstick yardstick = {};  ///< none: not compared with one
};

struct SimulateOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<ScenarioResult> results;                  ///< of every scenario, the interrupted ones too
  std::optional<std::vector<EnduranceResult>> endured;  ///< where it is wanted; fewer if interrupted
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of those in the folder
  double seconds = 0.0;            ///< that the rollouts took
};

/// Checks rollouts and, if every scenario was extended, the endurance. set: name of the gain set, empty where
/// there is but one. Returns true if it was.
bool check_rollouts(const RolloutSettings& settings, const std::vector<ScenarioResult>& results,
                    const std::optional<std::vector<EnduranceResult>>& endured, const std::string& set,
                    SimulationVerdict& verdict);

/// How rollouts are made in a folder; empty: they leave no recordings.
SimulateOptions simulate_options(const RolloutSettings& settings, const std::string& folder,
                                 const std::string& set, SessionObserver& observer);

/// Extends the scenarios, where that is wanted and `stop` is not.
std::optional<std::vector<EnduranceResult>> extend_scenarios(const RolloutSettings& settings,
                                                             const GainsToSimulate& gains,
                                                             SessionObserver& observer,
                                                             const std::atomic<bool>& stop);

class SimulateSession {
 public:
  /// The observer outlives the session.
  SimulateSession(RolloutSettings settings, GainsToSimulate gains, SessionContext context,
                  SessionObserver& observer);

  /// Runs it; may be called once. Throws InputError if the folder is used, if a path winds a joint up, or if
  /// the recordings do not fit in memory; FailedError if a file cannot be written.
  SimulateOutcome run();

 private:
  void write_files();
  void write_errors(const YardstickFiles& yardstick);
  void write_conclusion();

  RolloutSettings settings_;
  GainsToSimulate gains_;
  SessionContext context_;
  SessionObserver& observer_;
  SimulateOutcome outcome_;
};

}  // namespace armtune::internal
