#pragma once
// The one declaration of a rollout CSV's columns: name, unit, meaning, value.

#include <functional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// What a row says of the periods since the row before: a limit must not be broken unseen between two rows.
enum class Over { kThisPeriod, kLargest, kSmallest };

struct Column {
  std::string name;  ///< a tree with '/', no commas
  std::string unit;
  std::string meaning;
  std::function<double(const Observation&)> value;
  Over over = Over::kThisPeriod;
};

/// Columns for a scenario's robot, `time` first. The scenario's robot must outlive them.
std::vector<Column> rollout_columns(const Scenario& scenario);

/// Columns of any of the scenarios, each name once.
std::vector<Column> rollout_columns(const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
