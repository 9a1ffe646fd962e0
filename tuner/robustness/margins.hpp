#pragma once
// How much further a gain set's closed loop can be pushed until it no longer stands.
//
// A loop stands in a scenario if its rollout completes, keeps the limits and leaves the torques alone: at
// most 1 % of the control periods may have a saturated joint. An unstable loop grows until something holds
// it, and in these arms that is torque saturation: it chatters from bound to bound, tracks hardly worse for a
// while, and would destroy a drive. Sound gains saturate for some periods at a change of state; from the edge
// to chattering it is a factor of hundreds, so that the share hardly matters to where the edge is.

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
  std::optional<double> stands;  ///< last value that stood; none: not even the nominal one
  std::optional<double> fails;   ///< its neighbour that did not; none: all up to the last one tried stand
  std::string reason;            ///< why it failed, such as a limit; no commas; empty where nothing failed
};

struct MarginOptions {
  std::vector<MetricLimit> limits = arm_limits();
  Stepper stepper = Stepper::kMidpoint;
  /// Where the edges are looked for. Simbody has the last word: what another engine found is a margin once
  /// Simbody too stands on the one side and fails on the other; otherwise it looks for the edge itself. What
  /// stood on the way to that edge is not simulated again.
  Engine engine = Engine::kSimbody;
  int workers = 1;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< margins; one call at a time
  std::function<void(const std::vector<Margin>& so_far)> finished;  ///< after each margin; one call at a time
};

/// Every margin in every scenario, margin by margin; those that were not done when `stop` became true are
/// missing. Each is a function of scenario, gains, limits, stepper and engine alone. gains: valid for every
/// scenario's robot.
std::vector<Margin> margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                            const MarginOptions& options, const std::atomic<bool>& stop);

/// Why a loop does not hold.
struct LoopFailure {
  std::string text;   ///< one clause; empty where the loop holds
  std::string joint;  ///< that shows it; empty where none is to blame alone
  double time = NAN;  ///< [s], of the first sign; NaN where a whole rollout is judged

  bool holds() const { return text.empty(); }
};

/// Returns why the loop does not hold in the scenario with the margin's quantity at `value`, or a failure
/// that holds where it does, as Simbody judges it. No value if `stop` cut the rollout short.
std::optional<LoopFailure> failure_at(MarginKind kind, double value, const Scenario& scenario,
                                      const Gains& gains, const MarginOptions& options,
                                      const std::atomic<bool>& stop);

/// The same of the scenario as it is.
std::optional<LoopFailure> loop_failure(const Scenario& scenario, const Gains& gains,
                                        const MarginOptions& options, const std::atomic<bool>& stop);

/// The smallest margin of a kind over the scenarios: where not even the nominal value stands, else where it
/// fails first. None unless every scenario's is there.
std::optional<Margin> least(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                            MarginKind kind);

}  // namespace armtune::internal
