#pragma once
// What a plan has reached, in words and figures: for the terminal, run.yaml and the report.

#include "tuner/planning/output/limit_use.hpp"

namespace armtune::internal {

/// "0.136 s is the least time found within the limits", "10 s: tool at most 0.0021 mm off its path, ...".
std::string plan_headline(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned);

/// What a reader of the headline should know besides: what smoothness costs, a target that is no longer
/// active.
std::vector<std::string> plan_notes(const PlanTask& task, const PlanProblem& problem,
                                    const PlannedTrajectory& planned);

/// "between the knots: torque of wrist_2_joint at most 1.0020 of its limit, gaze ..."; empty where a task
/// limits nothing of that kind.
std::string between_words(const std::vector<LimitUse>& uses);

/// Keys and values of run.yaml, beside what every run has there.
std::vector<std::pair<std::string, std::string>> plan_entries(const PlanTask& task,
                                                              const PlanProblem& problem,
                                                              const PlannedTrajectory& planned,
                                                              const std::vector<LimitUse>& uses);

}  // namespace armtune::internal
