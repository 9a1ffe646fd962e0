#pragma once
// Defines the kinds of runs. The kind is the armtune command that wrote a run folder, or kBenchmark.

namespace armtune::internal {

enum class RunKind {
  kSimulate,
  kTune,
  kPareto,
  kRobustness,
  kCompare,
  kPlan,
  kValidate,
  kCalibrate,
  kMargins,  ///< a report page can be made of the kinds before this one
  kSensitivity,
  kYardstick,
  kExcite,
  kIdentify,
  kBenchmark  ///< a program in benchmarks/
};

/// Returns the name of the command, such as "simulate"; empty for a value beyond the last kind.
constexpr const char* name(RunKind kind) {
  constexpr const char* kNames[] = {"simulate",  "tune",     "pareto",    "robustness", "compare",
                                    "plan",      "validate", "calibrate", "margins",    "sensitivity",
                                    "yardstick", "excite",   "identify",  "benchmark",  ""};
  return kNames[static_cast<int>(kind)];
}

/// True if a report page can be made of such a run.
constexpr bool has_page(RunKind kind) {
  return kind < RunKind::kMargins;
}

}  // namespace armtune::internal
