#pragma once
// Creates the study (armtune's description of a tuning problem) for a first task, and tests whether gains
// satisfy its constraints. If the start gains satisfy them, the search always ends with feasible gains.

#include <string>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Returns the text of study.yaml, which refers to gains.yaml and task.yaml beside it. scenario: the task.
std::string first_study_yaml(const Scenario& scenario);

/// A test of gains against the constraints of that study: on the arm, on random arms, and in the rollouts
/// that check its stability margins.
class FirstDemands {
 public:
  /// start: gains for the arm, for the same controller as the gains to be tested. workers: threads (>= 1).
  FirstDemands(const Scenario& scenario, const Gains& start, int workers);

  /// Returns which constraint `gains` break in armtune's own dynamics, as a clause; empty if none.
  std::string broken(const Gains& gains);

 private:
  Study study_;
  CandidateRunner runner_;
};

}  // namespace armtune::internal
