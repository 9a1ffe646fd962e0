#pragma once
// The yardstick compares a controller with the best motion that the arm's limits allow. For each event of a
// rollout, such as a lap of the path, it plans the best motion from the same state of the arm.

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"
#include "tuner/planning/yardstick/events.hpp"

namespace armtune::internal {

struct YardstickOptions {
  double velocity = 1.0;  ///< shares of the arm's limits
  double effort = 1.0;
  double gaze_threshold = 0.15;  ///< [rad]
  /// Path tolerance in the plan of a target switch [m]. It is wider if the rollout itself is farther from the
  /// path during the event.
  double path_tolerance = 1e-3;
  /// Distance that tool and joint origins keep from every obstacle's surface [m], if the scenario has any; 0:
  /// none. It is smaller if the rollout itself comes nearer during the event.
  double clearance = 0.0;
  /// Knots of each plan. A lap's plan has more if an interval would otherwise be longer than 25 ms, or 12.5
  /// ms if targets switch.
  int knots = 120;
};

/// The way in which the limit of an event (its least possible value) was found, or why there is none.
enum class MeasureStatus {
  kSolved,
  kWithoutClearance,  ///< solved, but only with the obstacles left out
  kPastNextSwitch,    ///< solved, but even the best plan gets there only after the targets switch again
  kThereAtOnce,       ///< limit 0: at its beginning the gaze is within its threshold, or the tool on the path
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
  double limit = 0.0;        ///< least possible value of the event's `reached`; NaN if none was found
  double clearance = 0.0;    ///< kept by the plan [m]; NaN without obstacles or with them left out
  std::string held_back_by;  ///< "velocity of wrist_2_joint"; empty: no limit holds it back, or no plan
  /// Returns reached / limit; NaN if either is missing or the limit is 0.
  double ratio() const;
};

/// Returns the task of the plan that an event is compared with. The plan stays as far from obstacles as the
/// options say or, if the rollout comes nearer during the event, as the rollout does.
PlanTask task_of(const Event& event, const Scenario& scenario, const YardstickOptions& options);

/// Returns the rms of the gaze angle of a motion at the given times [rad]. For a lap these are the times of
/// the rollout's rows, so that plan and rollout are compared by the same mean.
double gaze_rms(const Scenario& scenario, const RobotModel& robot, const Trajectory& trajectory,
                const std::vector<double>& times);

/// Plans the best motion for an event, and returns its value as the limit of the event.
Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer);

/// Returns the limit of the scenario's slowest target switch [s]. The metric reacquisition/time is the
/// time of this switch. NaN if the switch has no limit, or if there is no switch.
double reacquisition_limit(const std::vector<Measure>& measures, const std::string& scenario);

}  // namespace armtune::internal
