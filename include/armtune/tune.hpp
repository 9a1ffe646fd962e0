#pragma once
// The search for better gains, and what was found.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armtune/rollout.hpp"
#include "armtune/study.hpp"
#include "armtune/verdict.hpp"

namespace armtune {

struct TuneOptions {
  std::string folder = {};  ///< new, for all files of the run; empty: nothing is written
  bool resume = false;      ///< continue the run in that folder
  int workers = 1;          ///< threads; results do not depend on it
  bool analysis = true;     ///< margins, sensitivity, and the checks that take long
  double deadline = 0.0;    ///< of one rollout, wall clock [s]; 0: 20 s and twice the simulated duration
  Watch watch = {};
};

/// One point of a search.
struct TunePoint {
  std::vector<double>
      x;  ///< coordinates, one for each of Study::parameters: 0 at the lower, 1 at the upper bound
  double objective = 0.0;            ///< the start scores 1
  double violation = 0.0;            ///< sum of the relative violations of the constraints; 0: feasible
  Engine engine = Engine::kSimbody;  ///< that gave them
};

struct Tuned {
  Gains start;
  Gains best;  ///< feasible, if any point was; the start where nothing was simulated
  double objective = NAN;
  bool feasible = false;
  bool interrupted = false;
  std::string reason = {};                       ///< why the search ended
  std::vector<std::string> parameters = {};      ///< names of the coordinates of a point
  std::vector<TunePoint> evaluations = {};       ///< in order
  std::vector<Rollout> before = {}, after = {};  ///< fresh rollouts of start and best, without recordings
  Verdict verdict = {};                          ///< of the simulation checks; without checks if interrupted
  std::vector<std::string> files = {};           ///< names of those in the folder
};

/// Runs a study: the same result for any number of workers. Throws InputError if the start gains give no
/// reference or the folder is used; FailedError if a file cannot be written, with what was finished kept in
/// the folder.
Tuned tune(const Study& study, const TuneOptions& options = {});

}  // namespace armtune
