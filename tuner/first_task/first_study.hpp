#pragma once
// Creates the study (armtune's description of a tuning problem) for a first task, and tests whether gains
// satisfy its constraints. If the start gains satisfy them, the search always ends with feasible gains.

#include <string>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Returns the text of study.yaml, which refers to gains.yaml and task.yaml beside it. scenario: the task.
std::string first_study_yaml(const Scenario& scenario);

/// Tests whether gains satisfy the constraints of that study: with the arm itself, with random arms, and in
/// the rollouts that check stability margins.
class FirstDemands {
 public:
  /// start: gains for this arm and for the same controller as the gains to be tested. workers: number of
  /// threads (>= 1).
  FirstDemands(const Scenario& scenario, const Gains& start, int workers);

  /// Simulates in armtune's own dynamics, and returns a clause that names a constraint that `gains` break.
  /// Returns an empty text if they break none.
  std::string broken(const Gains& gains);

 private:
  Study study_;
  CandidateRunner runner_;
};

}  // namespace armtune::internal
