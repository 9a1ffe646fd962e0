#pragma once
// What the interface gives of a rollout, made from what the simulation gives.

#include "armtune/rollout.hpp"
#include "armtune/study.hpp"
#include "sim/plant/engine.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/rollout/recorder.hpp"

namespace armtune {

struct RolloutMaker {
  /// recording: a rollout that has nothing else.
  static Rollout made(internal::ScenarioResult result, Rollout recording = {});
  /// Gives the rollout its recording. completed: for Recorder::rows.
  static void record(Rollout& rollout, internal::Recorder recorder, bool completed);
  static const internal::ScenarioResult& result_of(const Rollout& rollout);
};

/// The same gains for each of them.
internal::Engine internal_of(Engine engine);
/// Their insides, in order.
std::vector<internal::Scenario> internal_of(const std::vector<Scenario>& scenarios);

/// Throws InputError if the gains are not valid for the arm of one of the scenarios.
void require_fit(const Gains& gains, const std::vector<Scenario>& scenarios);
/// Throw InputError if a run folder is wanted for what no file says: the folder could not say what was
/// simulated.
void require_files(const Study& study, const std::string& folder);
void require_files(const std::vector<Scenario>& scenarios, const std::string& folder);
/// Throws InputError if the number of threads is not one to 1024.
void require_workers(int workers);

/// What never becomes true.
extern const std::atomic<bool> never_stopped;
inline const std::atomic<bool>& stop_of(const Watch& watch) {
  return watch.stop != nullptr ? *watch.stop : never_stopped;
}

}  // namespace armtune
