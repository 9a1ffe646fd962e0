#pragma once
// Computes how the metrics of a study change with its gains: the value and the derivatives of every metric
// that the objective or a constraint uses, in every scenario and on every arm. For a maximum over time, it
// also gives the samples near the maximum with their derivatives, so that a search can model the maximum as
// the largest of several linear functions:
//
//   const auto found = metric_derivatives(study, x, metrics_in_use(study), workers, stop);
//   for (const MetricDerivative& m : found->metrics)
//     for (const SampleRow& row : m.rows) bound(row.value + row.gradient.dot(d));  // at x + d
//
// All rollouts (simulations) run in armtune's own engine: the gain set and its perturbed copies side by side
// in the lanes of the processor. The result does not depend on the number of workers. Each copy counts in
// full in the simulated time of the workers.
//
// Derivatives are forward differences D(h) = (f(x + h e_i) - f(x)) / h, or backward ones near x_i = 1. They
// need one copy per gain, half as many as central differences, and the search pays for every copy. Their
// error has two parts:
// - truncation, h/2 |f''|, which is smaller for a smaller step;
// - rounding, about 1e-14 |f| / h, which is smaller for a larger step.
// Here f is a sample of a series, and x_i in [0, 1] a search coordinate. On three arms with four laws, the
// sum of both is smallest between h = 3e-7 and 3e-6. With h = 1e-6, half of the derivatives are within 2e-6
// of the largest derivative of the same sample by any gain, 99 % within 5e-5, and the worst (an RMS torque
// rate that hardly depends on the gains) within 1e-3. With two steps, 2 D(h) - D(2h) has no truncation error
// of the order of h: all are within 1e-4 for h = 3e-6. A step as small as this also leaves events (changes of
// state, slerps, saturation) in the same control period in nearly all copies.
//
// A rollout is a smooth function of the gains as long as no event moves to another control period. If an
// event of a copy is in another period than with the gain set itself, no derivative by this gain exists
// there:
// - a change of state, or the start or end of a slerp: from that period to the end of the rollout;
// - a torque that is saturated, an inverse that is damped, or a reference that is slowed in only one of the
//   two: in the periods where it differs.

#include <atomic>
#include <optional>
#include <vector>

#include "tuner/derivatives/metric_derivative.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

struct MetricDerivatives {
  std::vector<double> x;                  ///< search coordinates of the gain set
  std::vector<MetricDerivative> metrics;  ///< in the order of `uses`, each for all arms in order
  std::vector<MissingInterval> missing;   ///< ordered by scenario, arm, gain and time
  std::vector<RolloutResult> results;     ///< of x in the native engine, as in Evaluation::results
  /// Factors from derivatives by search coordinates to derivatives by gains in their units: dx_i / dgain_i.
  /// Gains that are linked to gain i change with it.
  Eigen::VectorXd per_gain;
  double simulated = 0.0;  ///< simulated time of all rollouts, copies included [s]
  long rollouts = 0;       ///< number of all rollouts, copies included
};

/// Returns the metrics whose derivatives a search of the study needs: those of its terms and constraints, in
/// every scenario where they count. For a demanded stability margin, they are the metrics by which
/// missing_to_hold (corner.hpp) judges the corner, except the number of saturated periods.
std::vector<MetricUse> metrics_in_use(const Study& study);

/// Returns the derivatives of the metrics at the search coordinates x (n, in [0, 1]). workers: made for
/// plan_of(study). Returns nothing if `stop` became true before the end. Throws InputError if an option is
/// outside its range, if x is not a point of the search space, or if the native engine does not have the
/// study's stepper.
///
/// If the rollout of x ends early, values and rows are those up to its end. If a copy ends earlier than the
/// rollout of x, the derivatives by this gain are missing after that.
std::optional<MetricDerivatives> metric_derivatives(const Study& study, const std::vector<double>& x,
                                                    const std::vector<MetricUse>& uses,
                                                    CandidateRunner& workers, const std::atomic<bool>& stop,
                                                    const DerivativeOptions& options = {});

}  // namespace armtune::internal
