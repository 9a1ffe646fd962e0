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
  std::string folder;     ///< folder for rollout_<scenario>.csv; empty: none is written
  int record_stride = 5;  ///< control periods per row
  /// Receives a scenario's recording instead of a file. It is called from any thread, one call at a time.
  /// completed: for Recorder::rows.
  std::function<void(std::size_t scenario, Recorder recorder, bool completed)> recorded;
  /// Deadline of one scenario, wall clock [s]; 0: derived from its duration (deadline_of). By default there
  /// is none, so that a rollout that a search completed is completed here too.
  double deadline = std::numeric_limits<double>::infinity();
  std::function<void(std::size_t done)> progress;  ///< one call at a time
};

/// Returns the results in the order of the scenarios. gains_of(scenario): its gains. Scenarios that did not
/// end before `stop` or their deadline have the status interrupted. Throws InputError if two scenarios share
/// a name, or if their recordings do not fit in memory (recording_memory.hpp).
std::vector<ScenarioResult> simulate(const std::vector<Scenario>& scenarios,
                                     const std::function<Gains(const Scenario&)>& gains_of,
                                     const SimulateOptions& options, const std::atomic<bool>& stop);

}  // namespace armtune::internal
