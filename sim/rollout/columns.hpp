#pragma once
// The one declaration of a rollout CSV's columns: name, unit, meaning, value.

#include <functional>
#include <string>
#include <vector>

#include "sim/rollout/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune {

struct Column {
  std::string name;  ///< a tree with '/', no commas
  std::string unit;
  std::string meaning;
  std::function<double(const Observation&)> value;
};

/// Columns for a scenario's robot, `time` first. The scenario's robot must outlive them.
std::vector<Column> rollout_columns(const Scenario& scenario);

/// Columns of any of the scenarios, each name once.
std::vector<Column> rollout_columns(const std::vector<Scenario>& scenarios);

}  // namespace armtune
