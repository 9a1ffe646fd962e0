#pragma once
// Defines the words that armtune writes into cells of CSV files, and compares when it reads them again, for
// example for a report. Each word is defined only here.

namespace armtune::internal::kept_words {

/// Names of limits of a planned motion, in limits.csv.
inline constexpr const char* kTorque = "torque";
inline constexpr const char* kToolPath = "tool path";
inline constexpr const char* kGaze = "gaze";
inline constexpr const char* kPathCoordinate = "path coordinate";

/// Outcomes in yardstick.csv: of an event of a rollout, such as a lap of the path, and of the best motion
/// that was planned for comparison.
inline constexpr const char* kAlreadyThere = "already there";
inline constexpr const char* kThereAtOnce = "there at once";
inline constexpr const char* kInfeasible = "infeasible";
inline constexpr const char* kSolved = "solved";

}  // namespace armtune::internal::kept_words
