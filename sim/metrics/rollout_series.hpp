#pragma once
// The series behind the metrics of a rollout (one simulated scenario): for each control period the values
// from which a metric is computed. A metric such as a maximum has a derivative that jumps where another
// period becomes the maximum, but the value of each period is a smooth function of the gains.

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// The way in which a metric follows from its series. Periods without a value do not count.
enum class SeriesKind {
  kLargest,   ///< the largest value
  kSmallest,  ///< the smallest value
  kRms,       ///< the root of the mean of the squares; a period may count several times
  kOutside    ///< time until the value stays below zero; the value is a distance from a threshold
};

/// Returns the kind of the metric's series. Returns nothing for a metric that has no series: a number of
/// periods, the time of a maximum, a distance in a cell, and the response to a stimulus.
std::optional<SeriesKind> series_kind(Metric metric);

struct MetricSeries {
  Metric metric = Metric::kPositionMax;
  std::size_t channels = 1;    ///< one, or one per joint
  std::vector<double> values;  ///< of all channels period by period, in the metric's unit; NaN: no value

  std::size_t periods() const { return values.size() / channels; }
  double at(std::size_t period, std::size_t channel = 0) const { return values[period * channels + channel]; }
};

/// The discrete part of what a rollout did in a control period, as bits. If two rollouts have the same bits
/// in all periods, the difference between them is a smooth function of the difference between their gains.
using PeriodMode = std::uint64_t;
inline constexpr PeriodMode kModeState = 0x7;              ///< bits of ControlState
inline constexpr PeriodMode kModeSlerping = 0x8;           ///< ControlOutput::slerping
inline constexpr PeriodMode kModeDamped = 0x10;            ///< ControlOutput::damped
inline constexpr PeriodMode kModeSlowed = 0x20;            ///< ControlOutput::pace below 1
inline constexpr PeriodMode kModeSaturated = 0xFFF00;      ///< one bit per joint
inline constexpr PeriodMode kModeTarget = 0xFFFFFF000000;  ///< index of the active target
inline constexpr int kFirstSaturatedBit = 8;
inline constexpr int kFirstTargetBit = 24;

struct RolloutSeries {
  double start = 0.0;                 ///< time of the first control period [s]
  double period = 0.0;                ///< control period [s]
  std::vector<MetricSeries> metrics;  ///< empty: nothing was recorded
  std::vector<PeriodMode> modes;      ///< of each period

  double time(std::size_t k) const { return start + static_cast<double>(k) * period; }
  /// Returns the series of the metric, or null if it was not recorded.
  const MetricSeries* find(Metric metric) const {
    for (const MetricSeries& series : metrics) {
      if (series.metric == metric) return &series;
    }
    return nullptr;
  }
};

}  // namespace armtune::internal
