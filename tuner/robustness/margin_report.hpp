#pragma once
// Formats stability margins as the file margins.csv and as tables for the terminal.

#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"

namespace armtune::internal {

/// Returns the text of margins.csv with the columns margin,unit,scenario,nominal,stands,fails,reason. There
/// is one row per margin and scenario. If a margin is known in every scenario, a row with the scenario `all`
/// gives the smallest one. `stands` is the last value that the loop tolerates; it is empty if the loop fails
/// at the nominal value already. `fails` is the neighbouring value, at which the loop fails; it is empty if
/// no value failed. Numbers have all digits that are needed to read back the same value.
std::string margins_csv(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

/// Returns a table of the margins of one gain set, with one line per scenario.
std::string margins_by_scenario(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

struct ComparedMargins {
  std::string name;  ///< name of the gain set
  std::vector<Margin> margins;
};

/// Returns a table with one column per gain set and one row per margin. A cell gives the smallest margin over
/// the scenarios. Lines below the table give the value at which the loop first fails, the scenario and the
/// cause.
std::string margins_table(const std::vector<Scenario>& scenarios, const std::vector<ComparedMargins>& sets);

}  // namespace armtune::internal
