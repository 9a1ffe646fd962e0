#pragma once
// Recognises columns of time stamps, and their units, by their names.

#include <optional>
#include <string>
#include <vector>

#include "sim/logs/time_column.hpp"

namespace armtune::internal {

/// The columns that hold the time, by their names, and the unit that the names state.
struct NamedTime {
  std::optional<std::size_t> column;
  std::optional<std::size_t> nanoseconds;  ///< of a pair of columns
  std::optional<TimeUnit> unit;
};

/// Returns the time columns. If the names of several columns fit, the stamp of a message's header is
/// preferred.
NamedTime find_named_time(const std::vector<std::string>& names);

/// Returns the unit that the name of a time column states, as in time_ms or "time [us]", or nothing.
std::optional<TimeUnit> stated_time_unit(const std::string& name);

/// True if the last word of the name is time, as in run_7_time.
bool ends_with_time(const std::string& name);

}  // namespace armtune::internal
