#pragma once
// Writes yardstick.csv. It has one row per event of a rollout, with the value that the controller reached and
// the best value that the arm's limits allow.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"

namespace armtune::internal {

/// Returns the text of yardstick.csv. Numbers have all digits that are needed to read back the same value. A
/// missing value is an empty cell.
std::string yardstick_csv(const std::vector<Measure>& measures);

/// Returns name, unit and meaning of every column of yardstick.csv.
std::vector<Column> yardstick_columns();

}  // namespace armtune::internal
