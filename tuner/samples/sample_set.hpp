#pragma once
// A fixed set of random arms on which the gains of one study are tuned together. Each metric is combined over
// the arms into one number, such as the mean or the worst value.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/perturbation.hpp"

namespace armtune::internal {

/// The way in which the values of a metric over the samples are combined into one number. Large values are
/// the bad ones, or small values if more of the metric is better.
enum class RiskMeasure {
  kMean,
  kQuantile,               ///< the value that a share `level` of the samples keeps
  kWorst,                  ///< the worst of all samples
  kConditionalValueAtRisk  ///< mean of the worst share 1 - level
};

/// Returns the names in study files, in the order of the enumeration.
std::span<const char* const> risk_measure_names();

/// A set of random arms. The scenario's own arm, which the robot's data describe, belongs to it too.
struct SampleSet {
  std::size_t samples = 8;    ///< number of random arms
  std::uint64_t seed = 1001;  ///< not that of `armtune robustness`, so that its arms are not those tuned on
  RiskMeasure measure = RiskMeasure::kConditionalValueAtRisk;
  double level = 0.8;  ///< level of the quantile and of CVaR, in (0, 1)
  Perturbation perturbation;
};

/// Returns the number of arms, including the scenario's own, which is the last one.
inline std::size_t arms(const SampleSet& set) {
  return set.samples + 1;
}

/// Returns the scenario with arm k of the set.
Scenario arm_of(const SampleSet& set, const Scenario& scenario, std::size_t k);

/// Returns the risk measure of the values (at least one). It is NaN if one of them is, because an arm
/// without a value must not improve the result.
double measured(const SampleSet& set, bool larger_is_better, std::vector<double> values);

/// Combines one scenario's results over the samples (at least one) into one result, with the risk measure of
/// every metric. It is completed if all samples are. Otherwise status, end and reason are those of the
/// sample that ended first, which the reason names.
RolloutResult folded(const SampleSet& set, std::span<const RolloutResult> samples);

}  // namespace armtune::internal
