#pragma once
// How good could any controller be? Each event of a rollout beside the best that the arm's limits allow from
// the same state on.

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"
#include "tuner/planning/yardstick/events.hpp"

namespace armtune::internal {

struct YardstickOptions {
  double velocity = 1.0;  ///< shares of the arm's limits
  double effort = 1.0;
  double gaze_threshold = 0.15;  ///< [rad]
  /// Of a switch's plan [m]; wider where the rollout itself is farther from the path meanwhile.
  double path_tolerance = 1e-3;
  /// Of every joint's origin from every obstacle's surface [m], where the scenario has any; 0: none. Less
  /// where the rollout itself comes nearer meanwhile.
  double clearance = 0.0;
  /// Of each plan; a lap's has more where an interval would be longer than 25 ms, or 12.5 ms if targets
  /// switch.
  int knots = 120;
};

/// What the limit is.
enum class MeasureStatus {
  kSolved,
  kWithoutClearance,  ///< solved, but only with the obstacles left out
  kPastNextSwitch,    ///< solved, but not even the best is there before the targets switch again
  kThereAtOnce,       ///< 0: the gaze is within its threshold, or the tool on the path, when it begins
  kInfeasible,
  kNotSolved,
  kInterrupted,
};
/// In a reader's words.
std::string words(MeasureStatus status);

struct Measure {
  std::string scenario;
  Event event;
  MeasureStatus status = MeasureStatus::kNotSolved;
  double limit = 0.0;        ///< least possible of what `reached` counts; NaN where none was found
  double clearance = 0.0;    ///< that the plan keeps [m]; NaN without obstacles or with them left out
  std::string held_back_by;  ///< "velocity of wrist_2_joint", "nothing"; empty where nothing was planned
  /// reached / limit; NaN where either is not there or the limit is 0.
  double ratio() const;
};

/// The plan that an event is compared with. It stays as far from obstacles as the options say, or, where the
/// arm is nearer when the event begins, as it is then.
PlanTask task_of(const Event& event, const Scenario& scenario, const YardstickOptions& options);

/// Rms of the gaze angle of a motion (a column a knot) at the times given [rad]: the mean that a lap's
/// rollout is judged by, whatever the knots.
double gaze_rms(const Scenario& scenario, const RobotModel& robot, const Trajectory& trajectory,
                const std::vector<double>& times);

Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer);

/// The limit of that of a scenario's switches which took longest, which is the one that reacquisition/time is
/// of [s]. NaN where it has none, or where there is no switch.
double reacquisition_limit(const std::vector<Measure>& measures, const std::string& scenario);

}  // namespace armtune::internal
