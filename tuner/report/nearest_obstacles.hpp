#pragma once
// Which of very many obstacles a replay shows.

#include "sim/csv/number_table.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Keeps the `most` obstacles whose surfaces come nearest to the tool of the recording, in the scenario's
/// order; the first ones where it does not say where the tool is.
void keep_nearest(const NumberTable& recording, std::size_t most, SceneScenario& scenario);

}  // namespace armtune::internal::report
