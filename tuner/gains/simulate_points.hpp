#pragma once
// Search points of a study, simulated.

#include <atomic>
#include <optional>
#include <vector>

#include "tuner/gains/study.hpp"
#include "tuner/gains/workers.hpp"

namespace armtune {

/// One evaluation per point, in order, with x, gains and results; still to be judged by an Objective. Nothing
/// if `stop` became true before all were done.
std::optional<std::vector<Evaluation>> simulate_points(const Study& study,
                                                       const std::vector<std::vector<double>>& points,
                                                       Workers& workers, const std::atomic<bool>& stop);

}  // namespace armtune
