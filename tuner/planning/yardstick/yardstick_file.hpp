#pragma once
// yardstick.csv: what was reached beside the limit, a row an event.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"

namespace armtune::internal {

/// Text of yardstick.csv. Numbers read back to the same bits; what there is not is an empty cell.
std::string yardstick_csv(const std::vector<Measure>& measures);

/// Name, unit and meaning of its columns.
std::vector<Column> yardstick_columns();

}  // namespace armtune::internal
