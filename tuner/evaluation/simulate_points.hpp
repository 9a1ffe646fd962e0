#pragma once
// Search points of a study, simulated.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// What workers of a study have to know. deadline: of one rollout [s], 0 for the default.
RolloutPlan plan_of(const Study& study, double deadline);

/// One evaluation per point, in order, with x, gains and results; still to be judged by an Objective. Nothing
/// if `stop` became true before all were done.
/// conditions: with limits per scenario (Objective::end_limits), or without, as for the start gains.
/// finished: once per point, as soon as it is whole: in any order, one call at a time, from any thread.
std::optional<std::vector<Evaluation>> simulate_points(
    const Study& study, const std::vector<std::vector<double>>& points, CandidateRunner& workers,
    const std::atomic<bool>& stop, const Conditions& conditions = {},
    const std::function<void(std::size_t, const Evaluation&)>& finished = {});

}  // namespace armtune::internal
