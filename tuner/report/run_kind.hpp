#pragma once
// What kind of run left a folder.

#include <string>

namespace armtune::internal::report {

enum class RunKind { kSimulate, kTune, kPareto, kRobustness, kCompare, kPlan };

/// "simulate", "tune" ...: the command.
constexpr const char* name(RunKind kind) {
  constexpr const char* kNames[] = {"simulate", "tune", "pareto", "robustness", "compare", "plan", ""};
  return kNames[static_cast<int>(kind)];
}

/// By its journal, else by the files in it. Throws InputError if it is no folder that a report is made of.
RunKind kind_of(const std::string& folder);

}  // namespace armtune::internal::report
