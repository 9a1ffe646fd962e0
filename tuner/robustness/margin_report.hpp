#pragma once
// Stability margins as a file and as text for a terminal.

#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"

namespace armtune::internal {

/// Returns the text of margins.csv: margin,unit,scenario,nominal,stands,fails,reason. There is one row per
/// margin and scenario. If the margin of every scenario is there, a row `all` has the least of them. `stands`
/// is empty if not even the nominal value stands, `fails` if nothing failed. Numbers read back to the same
/// bits.
std::string margins_csv(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

/// Returns a table of the margins of one gain set, one line per scenario.
std::string margins_by_scenario(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

struct ComparedMargins {
  std::string name;  ///< name of the gain set
  std::vector<Margin> margins;
};

/// Returns a table with the least margins of gain sets side by side. Below it stands what ends each margin,
/// and in which scenario.
std::string margins_table(const std::vector<Scenario>& scenarios, const std::vector<ComparedMargins>& sets);

}  // namespace armtune::internal
