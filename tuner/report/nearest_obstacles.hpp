#pragma once
// Selects the obstacles that a replay shows when a scenario has very many.

#include "sim/csv/number_table.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Keeps the `most` obstacles whose surfaces come nearest to the tool of the recording, in the order of the
/// scenario. If the recording has no position of the tool, keeps the first ones.
void keep_nearest(const NumberTable& recording, std::size_t most, SceneScenario& scenario);

}  // namespace armtune::internal::report
