#pragma once
// Defines the kinds of limits of a planned motion, and the words by which limits.csv stores them.

#include "tuner/record/words.hpp"

namespace armtune::internal {

enum class LimitKind {
  kPosition,
  kVelocity,
  kAcceleration,
  kJerk,
  kTorque,
  kToolPath,
  kGaze,
  kObstacle,  ///< distance to an obstacle; this kind and the following ones are distances
  kCellPart,
  kFloor,
  kLinks,  ///< distance between links of the arm
};

/// Returns the word for the kind in limits.csv; empty for a value beyond the last kind.
inline const char* name(LimitKind kind) {
  constexpr const char* kNames[] = {"position",
                                    "velocity",
                                    "acceleration",
                                    "jerk",
                                    kept_words::kTorque,
                                    kept_words::kToolPath,
                                    kept_words::kGaze,
                                    "obstacle",
                                    "cell part",
                                    "floor",
                                    "links",
                                    ""};
  return kNames[static_cast<int>(kind)];
}

inline bool is_distance(LimitKind kind) {
  return kind >= LimitKind::kObstacle;
}

}  // namespace armtune::internal
