#pragma once
// Finds out which armtune command wrote a run folder. The report page depends on it.

#include <string>

namespace armtune::internal::report {

enum class RunKind { kSimulate, kTune, kPareto, kRobustness, kCompare, kPlan };

/// Returns the name of the command, such as "simulate" or "tune".
constexpr const char* name(RunKind kind) {
  constexpr const char* kNames[] = {"simulate", "tune", "pareto", "robustness", "compare", "plan", ""};
  return kNames[static_cast<int>(kind)];
}

/// Finds the kind of run by its journal, or else by the files in the folder. Throws InputError if no report
/// can be made from the folder.
RunKind kind_of(const std::string& folder);

}  // namespace armtune::internal::report
