#pragma once
// Margins as a file and as text for a terminal.

#include <string>
#include <vector>

#include "tuner/robustness/margins.hpp"

namespace armtune::internal {

/// margins.csv: margin,unit,scenario,nominal,stands,fails,reason. A row per margin and scenario, and one
/// `all` with the least of them where every scenario's is there. `stands` is empty where not even the nominal
/// value stands, `fails` where nothing failed. Numbers read back to the same bits.
std::string margins_csv(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

/// The margins of one gain set, scenario by scenario, and the least of them.
std::string margins_by_scenario(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins);

struct ComparedMargins {
  std::string name;  ///< of the gain set
  std::vector<Margin> margins;
};

/// The least margins of gain sets side by side, and below them what ends each and in which scenario.
std::string margins_table(const std::vector<Scenario>& scenarios, const std::vector<ComparedMargins>& sets);

}  // namespace armtune::internal
