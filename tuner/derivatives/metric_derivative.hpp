#pragma once
// The derivatives of one metric in one rollout (one simulated scenario) by the gains of a study, and options
// for computing them (metric_derivatives.hpp).

#include <Eigen/Core>
#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

struct DerivativeOptions {
  double step = 1e-6;  ///< h, in search coordinates; in [1e-9, 0.1]
  /// True: every gain has a second copy, with the step 2h. Both differences together are more accurate. A
  /// derivative counts as missing if they do not agree (kStepsAgree), which finds events of which the
  /// rollouts keep no record. The best step is then 3e-6.
  bool two_steps = false;
  double band = 0.3;           ///< rows lie within this share of their series' range from its extreme value
  double spacing = 0.05;       ///< time of which only the most extreme sample becomes a row [s]
  std::size_t most_rows = 32;  ///< of one metric in one rollout; local extremes come first
};

/// The differences with the steps h and 2h agree if they differ by at most this share of the largest
/// derivative of the same sample, or of the same metric, by any gain.
inline constexpr double kStepsAgree = 0.01;

/// Rounding error of a sample of the value v, relative to 1 + |v|. Errors are differences of positions [m,
/// rad] of the order of 1. A difference with the step h thus has a rounding error of kRolloutRounding (1 +
/// |v|) / h.
inline constexpr double kRolloutRounding = 1e-14;

/// One metric in one scenario.
struct MetricUse {
  Metric metric = Metric::kPositionMax;
  std::size_t scenario = 0;  ///< index into simulated_scenarios(study), corners included
  bool operator==(const MetricUse&) const = default;
};

enum class MetricShape {
  kLargest,   ///< the largest value of its rows
  kSmallest,  ///< the smallest value of its rows
  kRms,       ///< root mean square over time; no rows
  kTime,      ///< time until a value stays below a threshold; no rows
  kOther      ///< differenced as a whole; no rows. The derivative of a number of periods is zero.
};

/// A sample of the series behind a metric. To first order its value at x + d is value + gradient . d.
struct SampleRow {
  std::size_t period = 0;    ///< number of the control period, counted from 0
  int channel = 0;           ///< joint, if the series has one channel per joint; otherwise 0
  double time = 0.0;         ///< [s]
  double value = 0.0;        ///< in the metric's unit
  Eigen::VectorXd gradient;  ///< by the search coordinates (n); zero where it does not exist
  std::vector<int> missing;  ///< gains by which the derivative does not exist; usually empty
};

/// One metric in one rollout, that is, in one scenario with one arm.
struct MetricDerivative {
  MetricUse use;
  std::size_t arm = 0;  ///< number of the random arm (sample_set.hpp); 0 without random arms and in corners
  MetricShape shape = MetricShape::kOther;
  double value = 0.0;  ///< in the native engine, in the metric's unit; NaN if the metric has no value
  /// By the search coordinates (n); zero where it does not exist. For kLargest and kSmallest it is the
  /// gradient of the first row. For kTime it is the gradient of the time at which the series crosses the
  /// threshold, interpolated between two periods.
  Eigen::VectorXd gradient;
  std::vector<int> missing;     ///< gains by which the derivative does not exist; usually empty
  std::vector<SampleRow> rows;  ///< the most extreme first
};

/// What differs between the rollouts of a gain set and of its perturbed copy.
enum class EventCause { kState, kSlerp, kSaturation, kDampedInverse, kSlowedReference, kEnd };

/// An interval of a rollout in which the derivative by one gain does not exist.
struct MissingInterval {
  std::size_t scenario = 0;
  std::size_t arm = 0;
  int gain = 0;        ///< index into ParameterSpace::free
  double begin = 0.0;  ///< [s]
  double end = 0.0;    ///< [s]
  EventCause cause = EventCause::kState;
  bool operator==(const MissingInterval&) const = default;
};

}  // namespace armtune::internal
