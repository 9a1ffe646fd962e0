#pragma once
// Formats stability margins as the file margins.csv and as tables for the terminal.

#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"

namespace armtune::internal {

/// Returns the text of margins.csv: margin,unit,scenario,nominal,stands,fails,reason. There is one row per
/// margin and scenario. If the margin of every scenario is there, a row `all` has the least of them. `stands`
/// is the last value that the loop tolerates, or empty if the loop fails at the nominal value already.
/// `fails` is the next value tried, or empty if nothing failed. Numbers read back to the same bits.
std::string margins_csv(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

/// Returns a table of the margins of one gain set, one line per scenario.
std::string margins_by_scenario(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

struct ComparedMargins {
  std::string name;  ///< name of the gain set
  std::vector<Margin> margins;
};

/// Returns a table with the least margins of gain sets side by side. Lines below it give the value at which
/// the loop first fails, with cause and scenario.
std::string margins_table(const std::vector<Scenario>& scenarios, const std::vector<ComparedMargins>& sets);

}  // namespace armtune::internal
