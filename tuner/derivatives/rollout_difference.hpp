#pragma once
// The difference between the rollout (simulation) of a gain set and that of a perturbed copy: derivatives of
// metrics, and the periods in which they do not exist.

#include <optional>
#include <vector>

#include "sim/rollout/rollout_result.hpp"
#include "tuner/derivatives/metric_derivative.hpp"

namespace armtune::internal {

class RolloutDifference {
 public:
  /// base, copy: rollouts with recorded series, which must outlive this object. step: difference of the
  /// copy's coordinate.
  RolloutDifference(const RolloutResult& base, const RolloutResult& copy, double step);

  /// True if no event separates the two rollouts in this period, so that the derivative exists.
  bool exists_at(std::size_t period) const;

  /// Sets the derivatives by `gain` of a metric, whose rows were chosen from the base.
  void differentiate(int gain, MetricDerivative& derivative) const;

  /// Returns the intervals in which the derivative does not exist. Only times and causes are set.
  std::vector<MissingInterval> missing() const;

 private:
  /// A quotient, or nothing where no derivative exists.
  using Quotient = std::optional<double>;
  Quotient quotient(double base, double copy) const;
  Quotient of_sample(const MetricDerivative& derivative, const SampleRow& row) const;
  Quotient of_rms(const MetricDerivative& derivative) const;
  Quotient of_time(const MetricDerivative& derivative) const;
  Quotient of_whole(const MetricDerivative& derivative) const;
  EventCause cause_at(std::size_t period) const;

  const RolloutResult& base_;
  const RolloutResult& copy_;
  double step_;
  std::size_t end_;   ///< number of periods that both rollouts have
  std::size_t jump_;  ///< first period from which on no derivative exists
};

/// Returns the shape of a metric.
MetricShape shape_of(Metric metric);

}  // namespace armtune::internal
