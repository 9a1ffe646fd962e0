#include "tuner/samples/sample_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tuner/samples/statistics.hpp"

namespace armtune::internal {
namespace {

/// Returns the measure, other than the mean, of values in ascending order, of which the last is the worst.
double of_sorted(const SampleSet& set, const std::vector<double>& values) {
  switch (set.measure) {
    case RiskMeasure::kQuantile:
      return quantile(values, set.level);
    case RiskMeasure::kConditionalValueAtRisk:
      return conditional_value_at_risk(values, set.level);
    default:
      return values.back();
  }
}

}  // namespace

std::span<const char* const> risk_measure_names() {
  static constexpr const char* names[] = {"mean", "quantile", "worst", "cvar"};
  return names;
}

Scenario arm_of(const SampleSet& set, const Scenario& scenario, std::size_t k) {
  return k < set.samples ? perturbed(scenario, set.perturbation, set.seed, k) : scenario;
}

double measured(const SampleSet& set, bool larger_is_better, std::vector<double> values) {
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) return NAN;
  if (set.measure == RiskMeasure::kMean) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  const double sign = larger_is_better ? -1.0 : 1.0;
  for (double& v : values) v *= sign;
  std::sort(values.begin(), values.end());
  return sign * of_sorted(set, values);
}

std::vector<double> risk_weights(const SampleSet& set, bool larger_is_better,
                                 const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (set.measure == RiskMeasure::kMean) return std::vector<double>(n, 1.0 / static_cast<double>(n));
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return larger_is_better ? values[a] > values[b] : values[a] < values[b];
  });
  // The measure is linear in the sorted values, so a weight is its value for a unit vector.
  std::vector<double> weights(n);
  std::vector<double> unit(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    unit[i] = 1.0;
    weights[order[i]] = of_sorted(set, unit);
    unit[i] = 0.0;
  }
  return weights;
}

RolloutResult folded(const SampleSet& set, std::span<const RolloutResult> samples) {
  RolloutResult result;
  result.end_time = samples.front().end_time;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const RolloutResult& sample = samples[k];
    if (sample.status == RolloutStatus::kCompleted) continue;
    if (result.status != RolloutStatus::kCompleted && sample.end_time >= result.end_time) continue;
    result.status = sample.status;
    result.end_time = sample.end_time;
    result.reason = k < set.samples ? fmt::format("sample {}: {}", k, sample.reason) : sample.reason;
  }
  for (const Metric m : all_metrics()) {
    std::vector<double> values;
    values.reserve(samples.size());
    for (const RolloutResult& sample : samples) values.push_back(sample.metrics[m]);
    result.metrics[m] = measured(set, larger_is_better(m), std::move(values));
  }
  // Joint and time of the largest velocity are those of the arm that had it.
  double largest = -1.0;
  for (const RolloutResult& sample : samples) {
    const double ratio = sample.metrics[Metric::kJointVelocityMaxRatio];
    if (!(ratio > largest)) continue;
    largest = ratio;
    result.metrics.max_ratio_joint = sample.metrics.max_ratio_joint;
    result.metrics[Metric::kJointVelocityMaxRatioTime] = sample.metrics[Metric::kJointVelocityMaxRatioTime];
  }
  return result;
}

}  // namespace armtune::internal
