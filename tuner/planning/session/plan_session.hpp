#pragma once
// A run that plans a trajectory: solved, measured against its limits, and, where it has a folder, all of its
// files. It writes nothing unless there is a solution.

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
  RosVersion ros = RosVersion::kRos2;  ///< of joint_trajectory.yaml
};

struct PlanOutcome {
  std::optional<PlanProblem> problem;
  PlannedTrajectory planned;       ///< its result's status says whether there is a solution
  std::vector<LimitUse> uses;      ///< of a solution
  std::vector<std::string> files;  ///< names of those in the folder
  double seconds = 0.0;            ///< that solving took
};

class PlanSession {
 public:
  /// The observer outlives the session.
  PlanSession(PlanSettings settings, SessionContext context, SessionObserver& observer);

  /// Runs it; may be called once. Throws InputError if the folder is used or the task cannot be begun;
  /// FailedError if a file cannot be written.
  PlanOutcome run();

 private:
  void write_files();

  PlanSettings settings_;
  SessionContext context_;
  SessionObserver& observer_;
  PlanOutcome outcome_;
};

}  // namespace armtune::internal
