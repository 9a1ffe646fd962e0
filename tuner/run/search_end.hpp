#pragma once
// Defines the reasons why a search ends.

namespace armtune::internal {

enum class SearchEnd {
  kConverged,       ///< the solver found no better gains near the best ones
  kLevelsSearched,  ///< every level of a trade-off front was searched
  kEvaluations,     ///< the number of evaluations was used up
  kTime,            ///< the time limit was reached
  kInterrupted,     ///< the user or the system interrupted the run
  kSolverGaveUp,    ///< the solver reported an error
};

/// Returns the word for the reason in run.json; empty for a value beyond the last reason.
constexpr const char* name(SearchEnd end) {
  constexpr const char* kNames[] = {
      "converged", "levels_searched", "evaluations_used_up", "time_used_up", "interrupted", "solver_gave_up",
      ""};
  return kNames[static_cast<int>(end)];
}

}  // namespace armtune::internal
