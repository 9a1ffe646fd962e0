#pragma once
// Tunes gains: searches for the gains that minimise a study's objective within its constraints. This file has
// the options, the result and the function that runs the search.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armtune/rollout.hpp"
#include "armtune/study.hpp"
#include "armtune/verdict.hpp"

namespace armtune {

struct TuneOptions {
  std::string folder = {};  ///< new folder for all files of the run; empty: nothing is written
  bool resume = false;      ///< resume the run in that folder
  int workers = 1;          ///< threads; results do not depend on it
  bool analysis = true;     ///< compute margins, sensitivity, and the checks that take a long time
  double deadline = 0.0;    ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
  Watch watch = {};
};

/// One evaluated point of a search.
struct TunePoint {
  std::vector<double>
      x;  ///< coordinates, one for each of Study::parameters: 0 at the lower, 1 at the upper bound
  double objective = 0.0;            ///< relative to the objective of the start gains, which is 1
  double violation = 0.0;            ///< sum of the relative violations of the constraints; 0: feasible
  Engine engine = Engine::kSimbody;  ///< engine that simulated the point
  /// Violation of each constraint, relative to its limit; 0 or less: the constraint is kept. There is one
  /// value for each constraint of the study. One more value follows; it is 0 or less if every scenario
  /// completed.
  std::vector<double> constraints = {};
};

struct Tuned {
  Gains start;
  Gains best;  ///< feasible if any point was; the start gains if nothing was simulated
  double objective = NAN;
  bool feasible = false;
  bool interrupted = false;
  std::string reason = {};                       ///< why the search ended
  std::vector<std::string> parameters = {};      ///< names of the coordinates of a point
  std::vector<TunePoint> evaluations = {};       ///< all evaluated points, in order
  std::vector<Rollout> before = {}, after = {};  ///< new rollouts of start and best, without recordings
  Verdict verdict = {};                          ///< on the simulation checks; without checks if interrupted
  std::vector<std::string> files = {};           ///< names of the files in the folder
};

/// Runs a study. The result does not depend on the number of workers. Throws InputError if the objective of
/// the start gains cannot serve as a reference, for example because a scenario does not complete, or if the
/// folder is in use. Throws FailedError if a file cannot be written; finished results remain in the folder.
Tuned tune(const Study& study, const TuneOptions& options = {});

}  // namespace armtune
