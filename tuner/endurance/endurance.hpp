#pragma once
// Endurance: scenarios extended to a long time, and the first limit that breaks in it. Scenarios last about a
// minute; what drifts slowly (an adaptation that learns from noise, a joint that winds up) shows only later.
//
//   const auto results = endure(scenarios, gains, {.minutes = 30.0}, stop);
//   if (results[0].broken) fmt::print("{}\n", to_string(*results[0].broken));

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/limit_watch.hpp"
#include "sim/rollout/rollout.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {

struct EnduranceOptions {
  double minutes = VerdictThresholds().minutes;  ///< of simulated time, of every scenario
  Stepper stepper = Stepper::kMidpoint;          ///< kReference simulates in Simbody from the start
  int workers = 1;                               ///< threads
  std::function<void(std::size_t done, std::size_t all)> progress = {};  ///< scenarios; one call at a time
  double limit_share = 1.0;  ///< of velocity and effort limits, that has to be kept
  bool confirmed = true;     ///< Simbody simulates what fails in the native engine, and has the last word
};

struct EnduranceResult {
  std::string scenario;
  double simulated = 0.0;             ///< [s]
  std::optional<BrokenLimit> broken;  ///< the first limit that was passed
  std::string ended;                  ///< why it did not run to its end; empty if it did or a limit broke
  double rms_growth =
      0.0;  ///< of the errors (ErrorWindows); NaN where there was no tracking, or under 5 minutes
  double peak_growth = 0.0;
  Engine engine = Engine::kNative;  ///< that has the last word: Simbody where the native engine saw a fault

  /// True if it ran to its end within every limit.
  bool held() const { return !broken && ended.empty(); }
};

/// Returns the scenario with a duration of at least `seconds`.
Scenario extended_to(const Scenario& scenario, double seconds);

/// Returns how what a scenario asks for goes on beyond its own duration, one sentence for each part that
/// does not simply repeat: a step, a planned motion, waypoints, a schedule.
std::vector<std::string> how_extended(const Scenario& scenario);

/// Simulates every scenario for the asked time in the native engine, until a limit breaks. What fails there
/// is simulated again in Simbody, whose result counts, if that is asked for. gains_of: valid for the
/// scenario's robot. Scenarios that were not done when `stop` became true are missing.
std::vector<EnduranceResult> endure(const std::vector<Scenario>& scenarios,
                                    const std::function<Gains(const Scenario&)>& gains_of,
                                    const EnduranceOptions& options, const std::atomic<bool>& stop);

}  // namespace armtune::internal
