#pragma once
// Writes and reads the verdict on a gain set (include/armtune/verdict.hpp). It contains the simulation checks
// with their results, what was not checked, and what the checks assume. Commands print it last, the report
// shows it first, and exit codes depend on it.
//
//   SimulationVerdict verdict;
//   verdict.checks.push_back({CheckKind::kEffortLimit, false, "moving_target", "", "wrist_1_joint", 527.3});
//   fmt::print("{}", to_text(verdict));
//   // Simulation checks: failed: effort limit, wrist_1_joint, 527.300 s, in moving_target

#include <string>
#include <vector>

#include "armtune/verdict.hpp"

namespace armtune::internal {

using SimulationVerdict = Verdict;

/// Returns the verdict as one line, for the top of the report.
std::string headline(const SimulationVerdict& verdict);

/// Adds a line to one of the verdict's lists, unless it is there already.
void add_once(std::string text, std::vector<std::string>& list);

/// Returns the list of things that no command of armtune checks.
const std::vector<std::string>& never_checked();

/// Convert a verdict to the text of verdict.yaml, and read it back from such a file. Reading throws
/// InputError with file, line and key.
std::string verdict_yaml(const SimulationVerdict& verdict);
SimulationVerdict read_verdict(const std::string& path);

}  // namespace armtune::internal
