#pragma once
// Writes yardstick.csv: one row per event, with the value that was reached beside its limit.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"

namespace armtune::internal {

/// Returns the text of yardstick.csv. Numbers read back to the same bits; a missing value is an empty cell.
std::string yardstick_csv(const std::vector<Measure>& measures);

/// Returns name, unit and meaning of its columns.
std::vector<Column> yardstick_columns();

}  // namespace armtune::internal
