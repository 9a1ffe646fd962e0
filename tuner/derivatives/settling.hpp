#pragma once
// Finds when a series settles below zero, between the control periods. The metrics of settling times
// (SeriesKind::kOutside) are whole numbers of control periods, which have no derivative.

#include <optional>

#include "sim/metrics/rollout_series.hpp"

namespace armtune::internal {

struct Settling {
  std::size_t event = 0;  ///< period in which the measurement starts
  std::size_t period =
      0;              ///< first period below zero after the last one that is not; `event` if there is none
  double time = 0.0;  ///< from the event to the crossing of zero, interpolated between two periods [s]
};

/// Returns the longest settling of the series. For the reacquisition time, an event is a period in which the
/// target switches, and its measurement ends with the next one. For the settling time at a goal, the event is
/// the first period with a value. If the series does not settle, the time is that to the end of the
/// measurement. Returns nothing if there is no event.
std::optional<Settling> longest_settling(const RolloutSeries& rollout, const MetricSeries& series);

/// Returns the settling of the series after the event in this period.
Settling settling_after(const RolloutSeries& rollout, const MetricSeries& series, std::size_t event);

}  // namespace armtune::internal
