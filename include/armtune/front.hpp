#pragma once
// A search for the Pareto front of two or three criteria: the gains that no other gains dominate. It shows
// what a lower value of one criterion costs in another.

#include <string>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/study.hpp"

namespace armtune {

struct FrontOptions {
  std::string folder = {};   ///< new folder for all files of the run; empty: nothing is written
  bool resume = false;       ///< resume the run in that folder
  int workers = 1;           ///< threads; results do not depend on it
  std::size_t levels = 0;    ///< per criterion except the first; 0: 12, or 4 with three criteria
  long max_evaluations = 0;  ///< 0: four times the study's
  double deadline = 0.0;     ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
  Watch watch = {};
};

struct FrontPoint {
  Gains gains;
  std::vector<double> values = {};  ///< of the criteria, in their units
};

struct Front {
  std::vector<FrontPoint> points = {};  ///< feasible points, ascending in the first criterion
  FrontPoint start;                     ///< start gains and their values
  double hypervolume = 0.0;             ///< that the points dominate, with the start as reference
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
};

/// Searches the front of a study. criteria: two or three, each the name of a metric or "objective". The first
/// one is optimised while the others are limited to fixed levels. Throws as tune does.
Front front(const Study& study, const std::vector<std::string>& criteria, const FrontOptions& options = {});

}  // namespace armtune
