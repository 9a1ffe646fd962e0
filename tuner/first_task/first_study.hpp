#pragma once
// The study of a first task, and whether gains keep what it demands: its search can then only end with gains
// that do.

#include <string>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// The text of study.yaml, beside which lie gains.yaml and task.yaml. `scenario`: the task.
std::string first_study_yaml(const Scenario& scenario);

/// The demands of that study: on the arm, on arms at random, and at the corners of its margins.
class FirstDemands {
 public:
  /// start: gains for the arm, of the kind that is asked about. workers: threads (>= 1).
  FirstDemands(const Scenario& scenario, const Gains& start, int workers);

  /// Returns which demand `gains` break in armtune's own dynamics, as a clause; empty: none.
  std::string broken(const Gains& gains);

 private:
  Study study_;
  CandidateRunner runner_;
};

}  // namespace armtune::internal
