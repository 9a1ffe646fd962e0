#pragma once
// Creates the study of a first task, and tests whether gains satisfy its constraints. If the start gains do,
// the search of the study always ends with feasible gains.

#include <string>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Returns the text of study.yaml, which refers to gains.yaml and task.yaml beside it. scenario: the task.
std::string first_study_yaml(const Scenario& scenario);

/// The demands of that study: on the arm, on random arms, and at the corners of its margins.
class FirstDemands {
 public:
  /// start: gains for the arm, for the same controller as the gains to be tested. workers: threads (>= 1).
  FirstDemands(const Scenario& scenario, const Gains& start, int workers);

  /// Returns which demand `gains` break in armtune's own dynamics, as a clause; empty if none.
  std::string broken(const Gains& gains);

 private:
  Study study_;
  CandidateRunner runner_;
};

}  // namespace armtune::internal
