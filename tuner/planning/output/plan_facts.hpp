#pragma once
// Describes the result of a plan in words and numbers, for the terminal, run.json and the report.

#include "tuner/planning/output/limit_use.hpp"
#include "tuner/run/run_facts.hpp"

namespace armtune::internal {

/// Returns a headline such as "0.136 s is the least time found within the limits" or "for a motion of 10 s,
/// the least error found within the limits: tool at most 0.0021 mm off its path, ...".
std::string plan_headline(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned);

/// Returns remarks on the headline, one sentence for each of these that applies:
///   - the cost of smoothness is a noticeable part of the objective;
///   - the solver has multiplied the objective by a small factor;
///   - the plan ends after the next target switch.
std::vector<std::string> plan_notes(const PlanTask& task, const PlanProblem& problem,
                                    const PlannedTrajectory& planned);

/// Returns a text such as "between the knots: torque of wrist_2_joint at most 1.0020 times its limit...".
/// Knots are the points of the time grid. The text is empty if the task has no limit that the planner
/// enforces at the knots only.
std::string between_words(const std::vector<LimitUse>& uses);

/// Returns what run.json tells about a plan, in addition to what it tells about every run.
PlanFacts plan_facts(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned,
                     const std::vector<LimitUse>& uses);

}  // namespace armtune::internal
