#pragma once
// Converts the rows of a CSV file into the data of a 3D replay. The file records a rollout or a planned
// motion.

#include <vector>

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Returns the values of an error column. In some states the controller does not track the quantity. The file
/// has zeros there, and the returned values are NaN. The file of a plan has no column of states, so its
/// values are returned unchanged. position: true for an error of the tool's position.
std::vector<double> tracked(const NumberTable& rollout, std::size_t column, bool position);

/// Returns a replay with samples at a constant time step, at most one for each row. time: time of every row
/// on the scenario's clock [s]; at least one, not decreasing, between -1e9 and 1e9; rate: largest number of
/// samples per second, positive and finite. Throws InputError naming the file if a joint's column is missing.
Replay replay_of(const NumberTable& rollout, const SceneScenario& scenario, const Arm& arm,
                 const std::vector<double>& time, double rate);

}  // namespace armtune::internal::report
