#pragma once
// What becomes of a rollout.

#include <functional>
#include <string>

#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"

namespace armtune::internal {

enum class RolloutStatus {
  kCompleted,
  kDiverged,    ///< the state left every sensible range, or the engine gave up
  kHopeless,    ///< abandoned: it passed one of its end limits
  kNoSamples,   ///< it ran to the end without a planned motion, but no period counted as tracking
  kInterrupted  ///< the caller asked it to stop
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
  double end_time = 0.0;  ///< [s] simulated
  std::string reason;     ///< when, where and why; empty if completed
  Metrics metrics;        ///< up to the end time
};

/// Called once per control period, after the controller and before the plant moves. Return false to stop.
using Observer = std::function<bool(const Observation&)>;

}  // namespace armtune::internal
