#pragma once
// The verdict on a gain set: which simulation checks it passed, what was not checked, and what the checks
// assume.

#include <cmath>
#include <string>
#include <vector>

namespace armtune {

enum class CheckKind {
  kCompleted,      ///< every rollout reached its end and tracked its task
  kVelocityLimit,  ///< the arm's own limits
  kPositionLimit,
  kEffortLimit,
  kAccelerationLimit,
  kOscillation,  ///< no joint shakes, and no oscillation grows
  kContact,      ///< tool and joint origins (or links) stay outside every obstacle
  kSelf,         ///< links that are not neighbours do not touch each other
  kCell,         ///< the arm touches no part of its cell
  kFloor,        ///< the arm does not touch the floor
  kConstraints,  ///< the constraints of the study
  kTorqueDelay,  ///< the stability margins
  kGainFactor,
  kControlRate,
  kVelocityNoise,
  kRotorEstimate,   ///< the loop tolerates a third and three times an estimated rotor inertia
  kYield,           ///< enough of the random arms keep their limits
  kEndurance,       ///< extended scenarios keep every limit
  kErrorGrowth,     ///< errors do not grow in extended scenarios
  kBetterThanStart  ///< the result of a search is better than its start
};

/// Returns the name that is printed and written to files, such as "effort limit".
const char* name(CheckKind kind);

/// One check that was made. Its fields describe the worst result: where and when it occurred, and its value.
/// Fields that do not apply are empty or NaN.
struct Check {
  CheckKind kind = CheckKind::kCompleted;
  bool passed = true;
  std::string scenario = {};
  std::string arm = {};  ///< which of several arms, such as "random arm 3 of 6"
  std::string joint = {};
  double time = NAN;        ///< [s]
  double value = NAN;       ///< the measured value
  double threshold = NAN;   ///< the value that it is compared with
  std::string unit = {};    ///< unit of value and threshold
  std::string detail = {};  ///< further information in words, such as the constraint's name
};

struct Verdict {
  std::vector<Check> checks;
  std::vector<std::string> not_checked;
  std::vector<std::string> assumes;
  std::vector<std::string> notes;  ///< remarks, such as loosened thresholds or gains on their bounds

  /// True if every check that was made passed. A verdict without checks has not passed.
  bool passed() const;
};

/// Returns, for example, "effort limit, wrist_1_joint, 527.300 s, in moving_target: 94.1, threshold 56".
std::string to_text(const Check& check);

/// Returns the last lines of a run's output: "Simulation checks: passed" or "... failed: ...", then "Not
/// checked:", "Assumes:" and one "Note:" for each note.
std::string to_text(const Verdict& verdict);

}  // namespace armtune
