#pragma once
// Converts results of simulations into the types of the public interface.

#include "armtune/rollout.hpp"
#include "armtune/study.hpp"
#include "sim/plant/engine.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/rollout/recorder.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune {

struct RolloutMaker {
  /// Converts a result, but leaves out its broken limits. recording: a rollout that contains only the
  /// recorded table.
  static Rollout made(internal::ScenarioResult result, Rollout recording = {});
  /// Converts a result together with its broken limits. The arm's limits must have been checked during the
  /// rollout.
  static Rollout watched(internal::ScenarioResult result, Rollout recording = {});
  /// Moves the recording into the rollout. completed: true if the rollout completed (see Recorder::rows).
  static void record(Rollout& rollout, internal::Recorder recorder, bool completed);
  static const internal::ScenarioResult& result_of(const Rollout& rollout);
};

internal::Engine internal_of(Engine engine);
std::vector<internal::Scenario> internal_of(const std::vector<Scenario>& scenarios);

/// Throws InputError if there is no scenario, or if the gains are not valid for the arm of one of them.
void require_fit(const Gains& gains, const std::vector<Scenario>& scenarios);
/// Throws InputError if the number of threads is not between 1 and 1024.
void require_workers(int workers);

inline const std::atomic<bool> never_stopped{false};
inline const std::atomic<bool>& stop_of(const Watch& watch) {
  return watch.stop != nullptr ? *watch.stop : never_stopped;
}
/// Returns the data that a session needs if it was started through the library, not by a command.
inline internal::SessionContext context_of(const Watch& watch) {
  return {stop_of(watch), {{}, "(a program, through armtune's interface)"}};
}

}  // namespace armtune
