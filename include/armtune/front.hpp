#pragma once
// Searches for the Pareto front of two or three criteria. The front shows how much one criterion gets worse
// when another one improves. It consists of all gain sets that no other gain set dominates. One gain set
// dominates another if it is at least as good in every criterion, and better in at least one.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/study.hpp"

namespace armtune {

struct FrontOptions {
  std::string folder = {};  ///< new folder for all files of the run; empty: nothing is written
  bool resume = false;      ///< resume the run in that folder
  int workers = 1;          ///< threads; results do not depend on it
  /// Number of levels (see `front`) for each criterion but the first; 0: 12, or 4 with three criteria.
  std::size_t levels = 0;
  long max_evaluations = 0;  ///< largest number of evaluations; 0: four times that of the study
  double deadline = 0.0;     ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
  Watch watch = {};
};

struct FrontPoint {
  Gains gains;
  std::vector<double> values = {};  ///< values of the criteria, in their units
};

struct Front {
  std::vector<FrontPoint> points = {};  ///< feasible points, ascending in the first criterion
  FrontPoint start;                     ///< start gains and their values
  double hypervolume = 0.0;             ///< volume that the points dominate; reference point: start gains
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
};

/// Searches for the front of a study. criteria: two or three, each the name of a metric or "objective". The
/// first criterion is optimised several times. In each of these searches, the other criteria must not exceed
/// fixed upper bounds, called levels. Throws the same errors as tune.
Front front(const Study& study, const std::vector<std::string>& criteria, const FrontOptions& options = {});

}  // namespace armtune
