#pragma once
// Describes the outcome of a rollout (one simulated scenario): its status, when and why it ended, and its
// metrics.

#include <functional>
#include <string>

#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"
#include "sim/metrics/rollout_series.hpp"

namespace armtune::internal {

enum class RolloutStatus {
  kCompleted,
  kDiverged,    ///< a joint's state is not finite or far too fast (divergence.hpp), or the engine failed
  kHopeless,    ///< abandoned because a metric reached its limit (end_limit.hpp)
  kNoSamples,   ///< ran to the end without a planned motion, but no period counted as tracking
  kInterrupted  ///< stopped by the caller
};

constexpr const char* name(RolloutStatus status) {
  switch (status) {
    case RolloutStatus::kCompleted:
      return "completed";
    case RolloutStatus::kDiverged:
      return "diverged";
    case RolloutStatus::kHopeless:
      return "hopeless";
    case RolloutStatus::kNoSamples:
      return "no_samples";
    case RolloutStatus::kInterrupted:
      return "interrupted";
  }
  return "";
}

struct RolloutResult {
  RolloutStatus status = RolloutStatus::kCompleted;
  double end_time = 0.0;  ///< simulated time since the start of the rollout [s]
  std::string reason;     ///< when, where and why it ended; empty if completed
  Metrics metrics;        ///< over all periods up to the end
  RolloutSeries series;   ///< those that were asked for, up to the end
};

/// A function that is called once per control period, after the controller and before the plant (the
/// simulated arm) moves. It returns false to stop the rollout.
using Observer = std::function<bool(const Observation&)>;

}  // namespace armtune::internal
