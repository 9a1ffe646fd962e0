#pragma once
// Tests endurance: simulates scenarios for much longer than their usual minute, and finds the first limit
// that the arm breaks. Slow drifts become visible only then. Examples are an adaptation that learns from
// noise, and a joint that turns further and further in one direction.
//
//   const auto results = endure(scenarios, gains_of, {.minutes = 30.0}, stop);
//   if (results[0].broken) fmt::print("{}\n", to_string(*results[0].broken));

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/limit_watch.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/rollout/shake_watch.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {

struct EnduranceOptions {
  double minutes = VerdictThresholds().minutes;  ///< simulated time of every scenario
  Stepper stepper = Stepper::kMidpoint;          ///< kReference: all simulations are in Simbody
  int workers = 1;                               ///< threads
  std::function<void(std::size_t done, std::size_t all)> progress = {};  ///< scenarios; one call at a time
  double limit_share = 1.0;  ///< share of the velocity and effort limits that must be kept
  bool confirmed = true;     ///< true: Simbody repeats scenarios that fail in the native engine, and decides
};

struct EnduranceResult {
  std::string scenario;
  double simulated = 0.0;             ///< [s]
  std::optional<BrokenLimit> broken;  ///< the first limit that was broken
  std::string ended;                  ///< any other failure, such as an early end or a contact; else empty
  /// Growth of the errors (error_windows.hpp). NaN if there was no tracking, or less than 5 minutes of time.
  double rms_growth = 0.0;
  double peak_growth = 0.0;
  Engine engine = Engine::kNative;  ///< engine of this result, as `endure` describes
  std::optional<Shake> shake = {};  ///< the first joint that oscillated

  /// True if the rollout ran to its end within every limit, without a contact and without an oscillation.
  bool held() const { return !broken && ended.empty(); }
};

/// Returns the scenario with a duration of at least `seconds`.
Scenario extended_to(const Scenario& scenario, double seconds);

/// Returns sentences on how a scenario's task continues beyond its own duration. There is one for each part
/// of the task that is not a repeated path: a stimulus, a planned motion, waypoints, a schedule.
std::vector<std::string> how_extended(const Scenario& scenario);

/// Simulates every scenario for the requested time in the native engine (armtune's own dynamics), until a
/// limit is broken. With `confirmed`, a scenario that fails there is simulated again in Simbody, whose
/// result counts. gains_of: returns gains that are valid for the scenario's robot. Scenarios that were not
/// finished when `stop` became true are missing from the result.
std::vector<EnduranceResult> endure(const std::vector<Scenario>& scenarios,
                                    const std::function<Gains(const Scenario&)>& gains_of,
                                    const EnduranceOptions& options, const std::atomic<bool>& stop);

}  // namespace armtune::internal
