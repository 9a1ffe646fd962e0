#pragma once
// Computes stability margins by simulation: the largest additional delay, gain factor and noise, and the
// lowest control rate, that the closed loop of a gain set tolerates.
//
// A loop counts as stable in a scenario ("stands", "holds") if its rollout completes, keeps the limits
// of velocity, position and (if given) acceleration, touches nothing, and saturates a torque in at most 1 %
// of the control periods. The reason for the last condition: The motion of an unstable loop grows until
// something limits it. In these arms this is the saturation of the torques. The torques then chatter between
// their limits. For a while the tracking error hardly grows, but on a real arm a motor or gear would be
// destroyed. Good gains also saturate for a few periods when the controller switches to another of its
// states. When a loop becomes unstable, the number of saturated periods grows by a factor of hundreds.
// Therefore the margin hardly depends on the exact share.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tuner/robustness/limits.hpp"
#include "tuner/robustness/margin_kind.hpp"

namespace armtune::internal {

/// One margin in one scenario.
struct Margin {
  MarginKind kind = MarginKind::kTorqueDelay;
  std::string scenario;
  double control_period = 0.0;   ///< control period of the unchanged scenario [s]
  double nominal = 0.0;          ///< nominal value, in the margin's unit like `stands` and `fails`
  std::optional<double> stands;  ///< last value with a stable loop; none: it fails at the nominal value
  std::optional<double> fails;   ///< value, next to `stands`, at which the loop fails; none: no value fails
  std::string reason;            ///< cause of the failure, without commas; empty if nothing failed
};

struct MarginOptions {
  std::vector<MetricLimit> limits = arm_limits();
  Stepper stepper = Stepper::kMidpoint;
  /// Engine that searches for the edge, that is, for the values `stands` and `fails`. If it is not Simbody,
  /// Simbody simulates both values again. If the loop is not stable at `stands`, or does not fail at `fails`,
  /// the search is repeated in Simbody. Values that Simbody has simulated are not simulated again.
  Engine engine = Engine::kSimbody;
  int workers = 1;
  /// Called after each margin, with the number of finished margins and the number of all margins. One call at
  /// a time.
  std::function<void(std::size_t done, std::size_t all)> progress;
  std::function<void(const std::vector<Margin>& so_far)> finished;  ///< after each margin; one call at a time
};

/// Returns every margin in every scenario, margin by margin. Margins that were not done when `stop` became
/// true are missing. A margin depends only on the scenario, the gains, and `limits`, `stepper` and `engine`
/// of the options. gains: valid for the robots of all scenarios.
std::vector<Margin> margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                            const MarginOptions& options, const std::atomic<bool>& stop);

/// The reason why a loop does not count as stable (does not hold).
struct LoopFailure {
  std::string text;   ///< one clause; empty if the loop holds
  std::string joint;  ///< joint that breaks a limit or saturates; empty if the cause is no single joint
  double time = NAN;  ///< time of the failure [s]; NaN if it follows only from the complete rollout

  bool holds() const { return text.empty(); }
};

/// Simulates the scenario in Simbody with the margin's quantity at `value`, and returns why the loop fails.
/// If the loop is stable, the text of the failure is empty. Returns nothing if `stop` interrupted the
/// rollout.
std::optional<LoopFailure> failure_at(MarginKind kind, double value, const Scenario& scenario,
                                      const Gains& gains, const MarginOptions& options,
                                      const std::atomic<bool>& stop);

/// Does the same as failure_at, but with the unchanged scenario.
std::optional<LoopFailure> loop_failure(const Scenario& scenario, const Gains& gains,
                                        const MarginOptions& options, const std::atomic<bool>& stop);

/// Returns the smallest margin of a kind over the scenarios. A margin that fails at its nominal value is the
/// smallest. Returns nothing if the margin of any scenario is missing.
std::optional<Margin> least(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                            MarginKind kind);

}  // namespace armtune::internal
