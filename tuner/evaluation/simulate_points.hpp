#pragma once
// Simulates search points of a study.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Returns the plan that workers of a study need. deadline: of one rollout [s], 0 for the default.
RolloutPlan plan_of(const Study& study, double deadline);

/// Returns one evaluation per point, in order, with x, gains and results. An Objective must still judge them.
/// No value if `stop` became true before all were done.
/// conditions: with limits per scenario (Objective::end_limits), or without, as for the start gains.
/// finished: called once per point, as soon as it is whole. Calls come in any order, one at a time, from any
/// thread.
std::optional<std::vector<Evaluation>> simulate_points(
    const Study& study, const std::vector<std::vector<double>>& points, CandidateRunner& workers,
    const std::atomic<bool>& stop, const Conditions& conditions = {},
    const std::function<void(std::size_t, const Evaluation&)>& finished = {});

}  // namespace armtune::internal
