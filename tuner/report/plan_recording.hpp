#pragma once
// A plan's motion.csv and limits.csv as plots and a replay show them.

#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// "torque of elbow_joint", "tool path along y", "gaze".
std::string limit_words(const std::string& limit, const std::string& part);

/// Plots, end and replay of motion.csv, whose time counts from the plan's start; set, status and reason are
/// the caller's. scenario, arm: null where the folder has no scene; then without a replay. Throws InputError
/// naming the file if a column is missing.
Run plan_run_of(const NumberTable& motion, const SceneScenario* scenario, const Arm* arm,
                const Resolution& resolution);

/// From limits.csv: in its order, times counted from `start` [s]. arm: null where it is not known; all its
/// joints count as turning then. Throws InputError naming the file if a column is missing.
std::vector<PlanLimit> plan_limits_of(const CsvTable& limits, const Arm* arm, double start);

}  // namespace armtune::internal::report
