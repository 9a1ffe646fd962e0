#pragma once
// A fixed set of arms that a study tunes on, and what counts of a metric over them.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/perturbation.hpp"

namespace armtune::internal {

/// How the values of a metric over the samples become one number. Small values are the bad ones where more is
/// better.
enum class RiskMeasure {
  kMean,
  kQuantile,               ///< the value that a share `level` of the samples keeps
  kWorst,                  ///< of all samples
  kConditionalValueAtRisk  ///< mean of the worst share 1 - level
};

/// Names in study files, in the order of the enumeration.
std::span<const char* const> risk_measure_names();

/// Arms at random, and the scenario's own, which is the one that a robot's figures are known of.
struct SampleSet {
  std::size_t samples = 8;    ///< at random
  std::uint64_t seed = 1001;  ///< another than that of `armtune robustness`: its arms are not those tuned on
  RiskMeasure measure = RiskMeasure::kConditionalValueAtRisk;
  double level = 0.8;  ///< in (0, 1); of the quantile and of CVaR
  Perturbation perturbation;
};

/// How many arms that is with the scenario's own, the last one.
inline std::size_t arms(const SampleSet& set) {
  return set.samples + 1;
}

/// The scenario as arm k of the set meets it.
Scenario arm_of(const SampleSet& set, const Scenario& scenario, std::size_t k);

/// The measure of the values (at least one); NaN if any is: an arm that gave no value is not one that did
/// well.
double measured(const SampleSet& set, bool larger_is_better, std::vector<double> values);

/// One scenario's results (at least one) over the samples as one: every metric measured; completed if all
/// are, else status, end and reason of the sample that ended first, which is named.
RolloutResult folded(const SampleSet& set, std::span<const RolloutResult> samples);

}  // namespace armtune::internal
