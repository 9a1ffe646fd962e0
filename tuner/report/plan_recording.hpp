#pragma once
// Turns a plan's motion.csv and limits.csv into the plots, the replay and the limits of a report.

#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// Returns a limit in words, such as "torque of elbow_joint", "tool path along y" or "gaze".
std::string limit_words(const std::string& limit, const std::string& part);

/// Makes a run with the plots, end and replay of motion.csv; its time counts from the plan's start. The
/// caller sets `set`, `status` and `reason`. scenario, arm: null if the folder has no scene; then there is no
/// replay. Throws InputError naming the file if a column is missing.
Run plan_run_of(const NumberTable& motion, const SceneScenario* scenario, const Arm* arm,
                const Resolution& resolution);

/// Returns the limits of limits.csv in their order, with times counted from `start` [s]. arm: null if it is
/// not known; all joints count as revolute then. Throws InputError naming the file if a column is missing.
std::vector<PlanLimit> plan_limits_of(const CsvTable& limits, const Arm* arm, double start);

}  // namespace armtune::internal::report
