#pragma once
// Finds out which armtune command wrote a run folder. The contents of a report page depend on the command.

#include <string>

namespace armtune::internal::report {

enum class RunKind { kSimulate, kTune, kPareto, kRobustness, kCompare, kPlan };

/// Returns the name of the command, such as "simulate" or "tune".
constexpr const char* name(RunKind kind) {
  constexpr const char* kNames[] = {"simulate", "tune", "pareto", "robustness", "compare", "plan", ""};
  return kNames[static_cast<int>(kind)];
}

/// Returns the command that wrote the folder. It is read from the run's journal. If there is no journal, or
/// if it is damaged, the files in the folder decide. Throws InputError if no report can be made from the
/// folder.
RunKind kind_of(const std::string& folder);

}  // namespace armtune::internal::report
