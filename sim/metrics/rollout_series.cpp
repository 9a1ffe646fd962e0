#include "sim/metrics/rollout_series.hpp"

namespace armtune::internal {

std::optional<SeriesKind> series_kind(Metric metric) {
  switch (metric) {
    case Metric::kGazeTimeOutside:
    case Metric::kJointEffortSaturatedPeriods:
    case Metric::kClearanceSelf:
    case Metric::kClearanceCell:
    case Metric::kClearanceFloor:
      return std::nullopt;
    case Metric::kPositionRms:
    case Metric::kOrientationRms:
    case Metric::kLinearVelocityRms:
    case Metric::kAngularVelocityRms:
    case Metric::kGazeRms:
    case Metric::kGazeRateErrorRms:
    case Metric::kJointErrorRms:
    case Metric::kToolErrorRms:
    case Metric::kJointEffortRms:
    case Metric::kEffortRateRms:
    case Metric::kCompensationErrorRms:
      return SeriesKind::kRms;
    case Metric::kReacquisitionTime:
    case Metric::kGoalSettlingTime:
      return SeriesKind::kOutside;
    default:
      if (!only_worsens(metric)) return std::nullopt;
      return larger_is_better(metric) ? SeriesKind::kSmallest : SeriesKind::kLargest;
  }
}

}  // namespace armtune::internal
