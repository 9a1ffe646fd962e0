#pragma once
// A trajectory planned offline under the arm's limits. Needs armtune built with SuiteSparse: link
// armtune::planning.

#include <limits>
#include <string>
#include <vector>

#include "armtune/progress.hpp"

namespace armtune {

struct PlanOptions {
  std::string folder =
      {};  ///< new, for all files of the run, written where there is a solution; empty: nothing is written
  Watch watch = {};
};

/// How far a plan uses one of its limits.
struct PlanLimit {
  std::string limit = {};  ///< "velocity", "torque", "gaze", "distance to ..."
  std::string part = {};   ///< the joint or axis
  double used = 0.0;       ///< largest share of it, at any time: 1 at the limit
  double time = 0.0;       ///< of that [s]; NaN: at a knot
  bool binds = false;      ///< it holds the motion back somewhere
};

/// A motion of n joints at N moments.
struct Plan {
  bool solved = false;
  std::string status = {};                                     ///< such as "solved" or "infeasible"
  std::string headline = {};                                   ///< what was reached, for a person
  double duration = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  std::vector<std::string> joints = {};                        ///< n names
  std::vector<double> time = {};                               ///< N [s]
  std::vector<std::vector<double>> position = {};              ///< N x n [rad, m]
  std::vector<std::vector<double>> velocity = {};              ///< N x n [rad/s, m/s]
  std::vector<std::vector<double>> effort = {};                ///< N x n [N m, N]
  std::vector<PlanLimit> limits = {};                          ///< those that hold it back first
  std::vector<std::string> files = {};                         ///< names of those in the folder
};

/// Plans a bundled task by name, or a task file by path. Throws InputError if the task cannot be begun or the
/// folder is used; FailedError if a file cannot be written.
Plan plan(const std::string& task, const PlanOptions& options = {});

}  // namespace armtune
