#pragma once
// The rows of a rollout's or a plan's CSV that its replay shows.

#include <vector>

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// An error's column; no value in the states that do not track it, where the file has zeros. A plan's file
/// has no states: there every value counts. position: of the tool's position.
std::vector<double> tracked(const NumberTable& rollout, std::size_t column, bool position);

/// time: of every row, not falling, within 1e9, at least one [s], on the scenario's clock. rate: samples a
/// second at most, positive and finite; no more than there are rows. Throws InputError naming the file if a
/// joint's column is missing.
Replay replay_of(const NumberTable& rollout, const SceneScenario& scenario, const Arm& arm,
                 const std::vector<double>& time, double rate);

}  // namespace armtune::internal::report
