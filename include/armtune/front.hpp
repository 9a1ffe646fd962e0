#pragma once
// What less of one criterion costs in another: the gains that no others dominate.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/study.hpp"

namespace armtune {

struct FrontOptions {
  std::string folder = {};   ///< new, for all files of the run; empty: nothing is written
  bool resume = false;       ///< continue the run in that folder
  int workers = 1;           ///< threads; results do not depend on it
  std::size_t levels = 0;    ///< of each criterion but the first; 0: 12, with three criteria 4
  long max_evaluations = 0;  ///< 0: four times the study's
  double deadline = 0.0;     ///< of one rollout, wall clock [s]; 0: 20 s and twice the simulated duration
  Watch watch = {};
};

struct FrontPoint {
  Gains gains;
  std::vector<double> values = {};  ///< of the criteria, in their units
};

struct Front {
  std::vector<FrontPoint> points = {};  ///< feasible, ascending in the first criterion
  FrontPoint start;
  double hypervolume = 0.0;  ///< below the start
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of those in the folder
};

/// criteria: two or three, each a metric's name or "objective"; the first is searched. Throws as tune does.
Front front(const Study& study, const std::vector<std::string>& criteria, const FrontOptions& options = {});

}  // namespace armtune
