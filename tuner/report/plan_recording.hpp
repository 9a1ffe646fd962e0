#pragma once
// Converts the files motion.csv and limits.csv, which `armtune plan` writes, into data for a report page: the
// plots and the 3D replay of the planned motion, and the list of its limits.

#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// Returns a limit in words, such as "torque of elbow_joint", "tool path along y" or "gaze". limit: kind of
/// the limit, such as "torque"; part: the joint or axis, may be empty.
std::string limit_words(const std::string& limit, const std::string& part);

/// Returns a run with the plots, the end and the replay of motion.csv. Its times count from the plan's start.
/// The caller sets `set`, `status` and `reason`. scenario, arm: null if the folder has no scene; then there
/// is no replay. Throws InputError naming the file if a column is missing.
Run plan_run_of(const NumberTable& motion, const SceneScenario* scenario, const Arm* arm,
                const Resolution& resolution);

/// Returns the limits of limits.csv in the order of the file. Their times count from `start` [s]. arm: null
/// if the arm is unknown; then all joints count as revolute. Throws InputError naming the file if a column is
/// missing.
std::vector<PlanLimit> plan_limits_of(const CsvTable& limits, const Arm* arm, double start);

}  // namespace armtune::internal::report
