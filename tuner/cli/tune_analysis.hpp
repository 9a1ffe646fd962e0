#pragma once
// After a search: how far both loops can be pushed, and which gains matter.

#include <string>

#include "tuner/search/tune.hpp"

namespace armtune::cli {

struct AnalysisOptions {
  std::string folder;  ///< of the run
  int workers = 1;
};

/// What the figures alone do not say: prints it, and writes margins.csv and sensitivity.csv. Returns false if
/// interrupted: the run's own files are all there by then.
bool analyse(const Study& study, const TuneResult& result, const Objective& objective,
             CandidateRunner& workers, const AnalysisOptions& how);

}  // namespace armtune::cli
