#pragma once
// Plans a trajectory offline within the arm's limits. This requires an armtune that was built with
// SuiteSparse. Link the library armtune::planning.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "armtune/progress.hpp"

namespace armtune {

namespace internal {
struct MotionPlanner;
}

struct PlanOptions {
  std::string folder =
      {};  ///< new folder for all files of the run, written if a solution is found; empty: nothing is written
  Watch watch = {};
};

/// One limit of the task, and how close the planned motion comes to it. It is checked at the knots, which are
/// the times of Plan::time, and between them.
struct PlanLimit {
  std::string limit = {};  ///< "velocity", "torque", "gaze", "distance to ..."
  std::string part = {};   ///< the joint or axis
  double used = 0.0;       ///< largest used fraction of the limit over all times; 1: at the limit
  double time = 0.0;       ///< time of this largest use [s]; NaN if it is at a knot
  bool binds = false;      ///< true if the limit restricts the motion somewhere
};

/// The result of planning: a motion of n joints at N times, called knots.
struct Plan {
  bool solved = false;
  std::string status = {};                                     ///< such as "solved" or "infeasible"
  std::string headline = {};                                   ///< the result in words
  double duration = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  std::vector<std::string> joints = {};                        ///< n names
  std::vector<double> time = {};                               ///< N [s]
  std::vector<std::vector<double>> position = {};              ///< N x n [rad, m]
  std::vector<std::vector<double>> velocity = {};              ///< N x n [rad/s, m/s]
  std::vector<std::vector<double>> effort = {};                ///< N x n [N m, N]
  std::vector<PlanLimit> limits = {};                          ///< limits that restrict the motion come first
  std::vector<std::string> files = {};                         ///< names of the files in the folder
};

/// Plans a bundled task by name, or a task file by path. Throws InputError if the task cannot be started or
/// the folder is in use; FailedError if a file cannot be written.
Plan plan(const std::string& task, const PlanOptions& options = {});

/// Returns the planner for Study::from_controllers (ControllerStudyOptions::planner). It plans motions
/// through joint positions without times, and along waypoints of the tool.
std::shared_ptr<const internal::MotionPlanner> motion_planner();

}  // namespace armtune
