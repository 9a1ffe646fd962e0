#pragma once
// Declares all columns of the CSV file of a recorded rollout (one simulated scenario) in one place: name,
// unit, meaning, and the function that computes the value.

#include <functional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The value that a row shows in a column. It is the value in the row's own control period, or the largest or
/// smallest value in all periods since the previous row. With the largest or smallest value, a limit that is
/// violated between two rows is visible in the second row.
enum class Over { kThisPeriod, kLargest, kSmallest };

struct Column {
  std::string name;  ///< levels separated by '/', such as "joint/NAME/position"; no commas
  std::string unit;
  std::string meaning;
  std::function<double(const Observation&)> value;
  Over over = Over::kThisPeriod;
};

/// Returns the columns for a scenario's robot, `time` first. The scenario's robot must outlive them.
std::vector<Column> rollout_columns(const Scenario& scenario);

/// Returns the names of the columns, in order.
std::vector<std::string> column_names(const std::vector<Column>& columns);

/// Returns the columns that at least one of the scenarios has. Each name occurs once.
std::vector<Column> rollout_columns(const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
