#pragma once
// One set of gains over several scenarios, in parallel, with the files a person looks at afterwards.

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
  std::string folder;     ///< rollout_<scenario>.csv go here; empty: none are written
  int record_stride = 5;  ///< every k-th control period is written
  /// What becomes of a scenario's recording, in place of a file; any thread's, one call at a time. completed:
  /// for Recorder::rows.
  std::function<void(std::size_t scenario, Recorder recorder, bool completed)> recorded;
  /// Of one scenario, wall clock [s]; 0: by its duration (deadline_of). None unless given: what has kept one
  /// in a search already is simulated to its end.
  double deadline = std::numeric_limits<double>::infinity();
  std::function<void(std::size_t done)> progress;  ///< one call at a time
};

/// Results in the order of the scenarios. gains_of(scenario): its gains. Scenarios that were not reached
/// before `stop` or their deadline have the status interrupted. Throws InputError if two scenarios share a
/// name, or if their recordings do not fit in memory (recording_memory.hpp).
std::vector<ScenarioResult> simulate(const std::vector<Scenario>& scenarios,
                                     const std::function<Gains(const Scenario&)>& gains_of,
                                     const SimulateOptions& options, const std::atomic<bool>& stop);

}  // namespace armtune::internal
