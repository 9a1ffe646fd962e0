#pragma once
// Simulates points of a search. Each point stands for one set of gains, with which the arm is simulated in
// every scenario of the study.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Returns the data from which worker threads and processes simulate the rollouts of a study: scenarios,
/// random arms and integration method. deadline: wall-clock limit of one rollout [s], 0 for the default.
RolloutPlan plan_of(const Study& study, double deadline);

/// Returns one evaluation per point, in order, with x, gains and results. Objective and constraints are not
/// computed yet; Objective::judge computes them. Returns nothing if `stop` became true before all were done.
/// conditions: engine, and limits at which rollouts end early (Objective::end_limits). The start gains are
/// simulated without such limits.
/// finished: called once per point, as soon as all its scenarios are simulated. Calls come in any order, one
/// at a time, from any thread.
std::optional<std::vector<Evaluation>> simulate_points(
    const Study& study, const std::vector<std::vector<double>>& points, CandidateRunner& workers,
    const std::atomic<bool>& stop, const Conditions& conditions = {},
    const std::function<void(std::size_t, const Evaluation&)>& finished = {});

}  // namespace armtune::internal
