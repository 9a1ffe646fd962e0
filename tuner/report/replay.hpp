#pragma once
// Turns the rows of a rollout's or a plan's CSV file into a replay.

#include <vector>

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Returns the column of an error, with NaN in the states that do not track it, where the file has zeros. A
/// plan's file has no states, so every value counts. position: true for an error of the tool's position.
std::vector<double> tracked(const NumberTable& rollout, std::size_t column, bool position);

/// Samples the rows evenly in time for a replay, with no more samples than rows. time: time of every row on
/// the scenario's clock [s], at least one, not decreasing, within 1e9; rate: largest number of samples per
/// second, positive and finite. Throws InputError naming the file if a joint's column is missing.
Replay replay_of(const NumberTable& rollout, const SceneScenario& scenario, const Arm& arm,
                 const std::vector<double>& time, double rate);

}  // namespace armtune::internal::report
