#pragma once
// Chooses the samples of a series that determine its extreme value now or after a step of the gains.

#include "sim/metrics/rollout_series.hpp"
#include "tuner/derivatives/metric_derivative.hpp"

namespace armtune::internal {

/// Returns the samples of a series near its largest or smallest value, the most extreme first, without
/// gradients. They are chosen in three steps:
/// - Each channel is divided into windows of `spacing`, of which only the most extreme sample is kept.
/// - Samples farther from the extreme value than `band` times the range of the series are left out.
/// - If more than `most_rows` are left, local extremes are kept before other samples, and the more extreme
///   ones before the less extreme ones.
std::vector<SampleRow> peak_rows(const RolloutSeries& rollout, const MetricSeries& series, SeriesKind kind,
                                 const DerivativeOptions& options);

}  // namespace armtune::internal
