#pragma once
// Computes stability margins by simulation: how much extra delay, gain or noise, or how slow a control rate,
// the closed loop of a gain set tolerates.
//
// A loop counts as stable in a scenario ("stands", "holds") if its rollout completes, keeps the limits and
// does not saturate: at most 1 % of the control periods may have a saturated joint. The motion of an unstable
// loop grows until something limits it, in these arms torque saturation. The loop then chatters between the
// torque bounds, tracks hardly worse for a while, and would destroy a motor or gear. Sound gains saturate for
// some periods at a change of the controller's state. From the edge of stability to chattering, the number of
// such periods grows by a factor of hundreds. Therefore the exact share hardly changes where the edge is.

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
  double control_period = 0.0;   ///< the scenario's own [s]
  double nominal = 0.0;          ///< in the margin's unit, like the next two
  std::optional<double> stands;  ///< last value with a stable loop; none: not even the nominal one
  std::optional<double> fails;   ///< next value, at which the loop fails; none: no value tried fails
  std::string reason;            ///< cause of failure, such as a limit; no commas; empty if nothing failed
};

struct MarginOptions {
  std::vector<MetricLimit> limits = arm_limits();
  Stepper stepper = Stepper::kMidpoint;
  /// Engine in which the edges are searched. The edge that another engine finds counts only if Simbody
  /// confirms it: the loop must be stable on one side and fail on the other. Otherwise Simbody searches for
  /// the edge itself; values that it has tried before are not simulated again.
  Engine engine = Engine::kSimbody;
  int workers = 1;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< margins; one call at a time
  std::function<void(const std::vector<Margin>& so_far)> finished;  ///< after each margin; one call at a time
};

/// Returns every margin in every scenario, margin by margin. Margins that were not done when `stop` became
/// true are missing. Each depends on scenario, gains, limits, stepper and engine alone. gains: valid for
/// every scenario's robot.
std::vector<Margin> margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                            const MarginOptions& options, const std::atomic<bool>& stop);

/// The reason why a loop does not count as stable (does not hold).
struct LoopFailure {
  std::string text;   ///< one clause; empty if the loop holds
  std::string joint;  ///< joint that shows it; empty if no single joint does
  double time = NAN;  ///< time of the first sign [s]; NaN if a whole rollout is judged

  bool holds() const { return text.empty(); }
};

/// Returns why the loop does not hold in the scenario with the margin's quantity at `value`, as Simbody
/// judges it. If the loop holds, the text of the returned failure is empty. No value if `stop` cut the
/// rollout short.
std::optional<LoopFailure> failure_at(MarginKind kind, double value, const Scenario& scenario,
                                      const Gains& gains, const MarginOptions& options,
                                      const std::atomic<bool>& stop);

/// Returns the same for the unchanged scenario.
std::optional<LoopFailure> loop_failure(const Scenario& scenario, const Gains& gains,
                                        const MarginOptions& options, const std::atomic<bool>& stop);

/// Returns the smallest margin of a kind over the scenarios: one that fails at its nominal value already,
/// else the one that fails first. No value unless the margin of every scenario is there.
std::optional<Margin> least(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                            MarginKind kind);

}  // namespace armtune::internal
