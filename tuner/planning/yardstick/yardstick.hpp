#pragma once
// Compares a controller with the best motion that the arm's limits allow (`armtune yardstick`). For each
// event of a rollout (a simulation of the controlled arm), such as a lap of the path, the best motion from
// the state of the arm at the start of the event is planned.

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"
#include "tuner/planning/yardstick/events.hpp"

namespace armtune::internal {

struct YardstickOptions {
  double velocity = 1.0;         ///< share of the arm's velocity limits that the plans may use
  double effort = 1.0;           ///< share of the arm's effort limits that the plans may use
  double gaze_threshold = 0.15;  ///< gaze angle below which a target is acquired [rad]
  /// Path tolerance in the plan of a target switch [m]. A plan gets a wider tolerance if the rollout itself
  /// is farther from the path during the event.
  double path_tolerance = 1e-3;
  /// Distance that the plan keeps between the surface of every obstacle and the tool and joint origins [m].
  /// 0: no distance is kept. A plan keeps a smaller distance if the rollout itself comes nearer during the
  /// event.
  double clearance = 0.0;
  /// Number of intervals of each plan's time grid. The plan of a lap has more if an interval would otherwise
  /// be longer than 25 ms (12.5 ms if the gaze switches to another target during the lap).
  int knots = 120;
};

/// The way in which the limit of an event was found, or why there is none. The limit of an event is the value
/// of Event::reached that the best planned motion within the arm's limits attains.
enum class MeasureStatus {
  kSolved,
  kWithoutClearance,  ///< solved, but only with the obstacles left out
  kPastNextSwitch,    ///< solved, but even the best plan reaches the target only after the next switch
  kThereAtOnce,       ///< limit 0: gaze within its threshold, or tool on its path, from the beginning
  kInfeasible,
  kNotSolved,
  kInterrupted,
};
/// Returns the status as text.
std::string words(MeasureStatus status);

struct Measure {
  std::string scenario;
  Event event;
  MeasureStatus status = MeasureStatus::kNotSolved;
  double limit = 0.0;        ///< limit of the event (see MeasureStatus); NaN if none was found
  double clearance = 0.0;    ///< distance that the plan keeps from obstacles [m]; NaN: none
  std::string held_back_by;  ///< limit that prevents a better value, such as "reach of the arm"; empty: none
  /// Returns event.reached divided by `limit`. NaN if either is missing or the limit is 0.
  double ratio() const;
};

/// Returns the task of the plan that an event is compared with. The plan stays as far from obstacles as the
/// options say or, if the rollout comes nearer during the event, as the rollout does.
PlanTask task_of(const Event& event, const Scenario& scenario, const YardstickOptions& options);

/// Returns the rms of the gaze angle of a motion over the given times [rad]. For a lap these are the times of
/// the rollout's rows. The values of plan and rollout are then means over the same times.
double gaze_rms(const Scenario& scenario, const RobotModel& robot, const Trajectory& trajectory,
                const std::vector<double>& times);

/// Plans the best motion for an event. Returns the value of the event's metric for this motion, which no
/// controller can improve on within the same limits. If no plan keeps its distance from the obstacles, the
/// plan is made without them.
Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer);

/// Returns the limit (see MeasureStatus) of one target switch of the scenario: the one that took the
/// controller longest [s]. The controller's time for this switch is the metric reacquisition/time. Returns
/// NaN if the switch has no limit, or if there is no switch.
double reacquisition_limit(const std::vector<Measure>& measures, const std::string& scenario);

}  // namespace armtune::internal
