#pragma once
// Simulates one gain set in several scenarios in parallel, with or without recordings.

#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/rollout/recorder.hpp"

namespace armtune::internal {

struct SimulateOptions {
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;
  int workers = 1;
  std::string folder;     ///< folder for the files rollout_<scenario>.csv; empty: no files are written
  int record_stride = 5;  ///< control periods per row of a recording
  bool mcap = false;      ///< true: also write the recordings as rollout_<scenario>.mcap (motion_bag.hpp)
  /// If set, receives each recording, which stays in memory. It is called from any thread, one call at a
  /// time. completed: to be passed to Recorder::rows.
  std::function<void(std::size_t scenario, Recorder recorder, bool completed)> recorded;
  /// Deadline of one scenario, wall clock [s]; 0: derived from its duration (deadline_of). By default there
  /// is no deadline. A rollout that was completed in a search is thus completed here too.
  double deadline = std::numeric_limits<double>::infinity();
  std::function<void(std::size_t done)> progress;  ///< number of scenarios done; one call at a time
};

/// Returns the results in the order of the scenarios. gains_of: returns the gains for a scenario. A scenario
/// that was stopped by `stop`, or by its deadline, has the status interrupted. Throws InputError if two
/// scenarios have the same name, or if the recordings do not fit in memory (recording_memory.hpp).
std::vector<ScenarioResult> simulate(const std::vector<Scenario>& scenarios,
                                     const std::function<Gains(const Scenario&)>& gains_of,
                                     const SimulateOptions& options, const std::atomic<bool>& stop);

}  // namespace armtune::internal
