#pragma once
// A fixed set of random arms. A study can tune one gain set for all arms of such a set. Each metric is then
// combined over the arms into one number, such as the mean or the worst value.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/perturbation.hpp"

namespace armtune::internal {

/// The way in which the values of a metric over the arms are combined into one number. The worst value is the
/// largest one, or the smallest one if larger values of the metric are better.
enum class RiskMeasure {
  kMean,
  kQuantile,               ///< the value that the share `level` of the arms attains or improves on
  kWorst,                  ///< the worst value
  kConditionalValueAtRisk  ///< mean of the worst values; their share of all values is 1 - level
};

/// Returns the names in study files, in the order of the enumeration.
std::span<const char* const> risk_measure_names();

/// A set of random arms. The set also contains the arm of the scenario itself (the nominal arm), as the
/// robot's data describe it.
struct SampleSet {
  std::size_t samples = 8;    ///< number of random arms
  std::uint64_t seed = 1001;  ///< differs from that of `armtune robustness`, which thus tests on new arms
  RiskMeasure measure = RiskMeasure::kConditionalValueAtRisk;
  double level = 0.8;  ///< used by kQuantile and kConditionalValueAtRisk, in (0, 1)
  Perturbation perturbation;
};

/// Returns the number of arms: the random arms and the nominal arm, which is the last one.
inline std::size_t arms(const SampleSet& set) {
  return set.samples + 1;
}

/// Returns the scenario with arm k of the set.
Scenario arm_of(const SampleSet& set, const Scenario& scenario, std::size_t k);

/// Returns the risk measure of the values (at least one). The result is NaN if one of the values is NaN,
/// because an arm without a value must not improve the result.
double measured(const SampleSet& set, bool larger_is_better, std::vector<double> values);

/// Returns the weights with which measured() is the weighted sum of these values (at least one, none NaN).
/// They are the derivatives of the measure by the values, as long as the order of the values stays the same.
std::vector<double> risk_weights(const SampleSet& set, bool larger_is_better,
                                 const std::vector<double>& values);

/// Combines one scenario's results on the arms (at least one) into one result, with the risk measure of every
/// metric. The result counts as completed if the rollouts of all arms are completed. Otherwise its status,
/// end and reason are those of the rollout that ended first. The reason names the arm if it is a random one.
RolloutResult folded(const SampleSet& set, std::span<const RolloutResult> samples);

}  // namespace armtune::internal
