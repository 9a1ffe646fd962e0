#pragma once
// The work of the command `armtune simulate`. It simulates scenarios with one gain set and checks the
// rollouts. If requested, it also extends each scenario to many simulated minutes (endurance). If the session
// has an output folder, it writes all files there.

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

/// A gain set to simulate. It must be valid for the robots of all scenarios.
struct GainsToSimulate {
  std::string name;                                ///< name of the set, such as "published"
  std::string path;                                ///< path of its file; empty: the gains are from no file
  std::function<Gains(const Scenario&)> gains_of;  ///< returns the gains for the scenario's robot
};

/// The way in which gain sets are simulated.
struct RolloutSettings {
  std::string folder;  ///< empty: nothing is written
  std::vector<Scenario> scenarios;
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;
  int workers = 1;           ///< number of threads
  int record_every = 5;      ///< control periods per row of the recordings
  double deadline = 0.0;     ///< for one scenario, wall clock [s]; 0: derived from its duration
  double endurance = 0.0;    ///< length to which every scenario is extended [min]; 0: not extended
  Yardstick yardstick = {};  ///< comparison with the best possible motions; empty: no comparison
  /// True: examine tasks (task_notes.hpp) and robot files (plausibility.hpp). This takes some milliseconds
  /// for each scenario, and adds warnings, and notes and assumptions in the verdict.
  bool examine = true;
  bool mcap = false;  ///< true: also write the recordings as MCAP files (motion_bag.hpp)
  /// Receives each recording, as in simulate.hpp; may be empty.
  std::function<void(std::size_t scenario, Recorder recorder, bool completed)> recorded = {};
};

struct SimulateOutcome {
  Ending ending = Ending::kInterrupted;
  std::vector<ScenarioResult> results;                  ///< one per scenario, also for interrupted ones
  std::optional<std::vector<EnduranceResult>> endured;  ///< of extended scenarios; fewer if interrupted
  SimulationVerdict verdict;
  std::vector<std::string> files;  ///< names of the files in the folder
  double seconds = 0.0;            ///< duration of the rollouts, wall clock [s]
};

/// Adds the checks of the rollouts to the verdict and, if every scenario was extended, the checks of the
/// extended scenarios. set: name of the gain set, empty if there is only one. Returns true if every scenario
/// was extended.
bool check_rollouts(const RolloutSettings& settings, const std::vector<ScenarioResult>& results,
                    const std::optional<std::vector<EnduranceResult>>& endured, const std::string& set,
                    SimulationVerdict& verdict);

/// Returns the options for simulate(). folder: folder for recordings; if empty, no recordings are written;
/// set: name of the gain set, for the progress.
SimulateOptions simulate_options(const RolloutSettings& settings, const std::string& folder,
                                 const std::string& set, SessionObserver& observer);

/// Simulates all scenarios, extended to settings.endurance. Returns nothing if this is 0, or if `stop` was
/// true at the beginning.
std::optional<std::vector<EnduranceResult>> extend_scenarios(const RolloutSettings& settings,
                                                             const GainsToSimulate& gains,
                                                             SessionObserver& observer,
                                                             const std::atomic<bool>& stop);

class SimulateSession {
 public:
  /// The observer must outlive the session.
  SimulateSession(RolloutSettings settings, GainsToSimulate gains, SessionContext context,
                  SessionObserver& observer);

  /// Runs the session. May be called only once. Throws InputError if the folder is not empty, if a path that
  /// is examined moves a joint beyond its position limits with any gains (refuse_winding), or if the
  /// recordings do not fit in memory. Throws FailedError if a file cannot be written.
  SimulateOutcome run();

 private:
  void examine_tasks();
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
