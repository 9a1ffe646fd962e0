#pragma once
// Declares all columns of the CSV file of a recorded rollout in one place: name, unit, meaning, and the
// function that computes the value.

#include <functional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The value of a column for the control periods since the row before: that of the row's own period, the
/// largest or the smallest. A limit that is violated between two rows must show in the second one.
enum class Over { kThisPeriod, kLargest, kSmallest };

struct Column {
  std::string name;  ///< a tree with '/', no commas
  std::string unit;
  std::string meaning;
  std::function<double(const Observation&)> value;
  Over over = Over::kThisPeriod;
};

/// Returns the columns for a scenario's robot, `time` first. The scenario's robot must outlive them.
std::vector<Column> rollout_columns(const Scenario& scenario);

/// Returns the columns of any of the scenarios, each name once.
std::vector<Column> rollout_columns(const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
