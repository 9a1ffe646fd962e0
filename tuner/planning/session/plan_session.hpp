#pragma once
// Does the work of `armtune plan`: plans a trajectory for a task, and measures how much of each limit the
// trajectory uses. If an output folder is given, all files are written there. Without a solution, nothing is
// written.

#include <optional>
#include <string>
#include <vector>

#include "tuner/planning/output/limit_use.hpp"
#include "tuner/planning/output/ros_trajectory.hpp"
#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

struct PlanSettings {
  std::string folder;  ///< empty: nothing is written
  PlanTask task;
  RosVersion ros = RosVersion::kRos2;  ///< version that joint_trajectory.yaml is written for
  bool mcap = false;                   ///< true: also write motion.csv as motion.mcap (motion_bag.hpp)
};

struct PlanOutcome {
  std::optional<PlanProblem> problem;
  PlannedTrajectory planned;       ///< a solution only if planned.result.status is kSolved
  std::vector<LimitUse> uses;      ///< empty without a solution
  std::vector<std::string> files;  ///< names of the files in the folder
  double seconds = 0.0;            ///< time that solving took
};

class PlanSession {
 public:
  /// The observer must outlive the session.
  PlanSession(PlanSettings settings, SessionContext context, SessionObserver& observer);

  /// Runs the session. May be called only once. Throws InputError if the folder exists and is not empty, or
  /// if plan_problem() refuses the task. Throws FailedError if a file cannot be written.
  PlanOutcome run();

 private:
  void write_files();

  PlanSettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  PlanOutcome outcome_;
};

}  // namespace armtune::internal
