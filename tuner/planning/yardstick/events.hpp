#pragma once
// Finds the events of a rollout, that is, of one simulated motion of a controlled arm. An event is a part of
// the rollout that can be compared with an optimal plan: the gaze (direction of the tool's z axis) switches
// to another target, the tool returns to its path, or the tool completes one lap of the path.

#include <string>
#include <vector>

#include "core/control/state_machine.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The kinds of events. The kind defines what Event::reached is.
enum class EventKind {
  kSwitch,  ///< time from the switch until the gaze angle stays under its threshold [s]
  kReturn,  ///< time from the start of the controller's return until the path is followed again [s]
  kLap,     ///< rms of the gaze angle over one lap of the path [rad]
};
std::string name(EventKind kind);
/// Returns the unit of `reached` for this kind.
std::string unit(EventKind kind);

/// The way in which an event ended.
enum class EventOutcome {
  kReached,
  kAlreadyThere,  ///< the goal was reached from the beginning; `reached` is 0 s
  kNotReached,    ///< the next switch came before the goal was reached
  kCutByEnd,      ///< the rollout ended before the goal was reached
  kCutByState,    ///< the controller entered another state first, to avoid an obstacle
};
/// Returns the outcome as text.
std::string words(EventOutcome outcome);

struct Event {
  EventKind kind = EventKind::kSwitch;
  EventOutcome outcome = EventOutcome::kReached;
  double time = 0.0;     ///< start of the event [s]
  double end = 0.0;      ///< latest time considered: next switch, or end of rollout, state or lap [s]
  double reached = 0.0;  ///< value that EventKind defines; NaN: not reached before `end`
  ControlState state = ControlState::kFollowTrajectory;  ///< state of the controller at `time`
  /// kSwitch: time until the gaze angle is under its threshold and stays there until the next switch or the
  /// end of the rollout, in any state [s]. If it does not stay there, this is the time until that switch or
  /// end. The metric reacquisition/time is the largest of these times.
  double settled = 0.0;
  double gaze = 0.0;     ///< gaze angle to the active target at `time` [rad]
  JointVector position;  ///< (n) at `time` [rad, m]
  JointVector velocity;  ///< (n) at `time` [rad/s, m/s]
  /// Largest distance of the tool from the path along one of the axes x, y, z during the event [m]. For a
  /// switch whose target was reached, errors count until kSwitchHold after the target was reached, as in the
  /// plan.
  double path_error = 0.0;
  /// Least distance of the tool, or of a joint origin that can move, from an obstacle's surface during the
  /// same period as for path_error [m]; infinite without obstacles.
  double nearest = 0.0;
  std::vector<double> times;  ///< kLap: times of the rows over which the rms is computed [s]
};

/// Time that the gaze must stay on target for a planned switch to count [s].
inline constexpr double kSwitchHold = 0.5;

/// Returns the events in order of time. rollout: table of rollout_<scenario>.csv; gaze_threshold: angle below
/// which a target is acquired [rad]. A switch that begins while the path is followed ends, at the latest,
/// when the path is left or the next switch begins. A switch that begins in another state, such as a return
/// or an evasion, ends at the latest at the next switch. Incomplete laps are left out. Switches while the arm
/// still moves out of its start pose (kLeaveSingularity) are left out too. Throws InputError if a column is
/// missing.
std::vector<Event> events_of(const CsvTable& rollout, const Scenario& scenario, double gaze_threshold);

}  // namespace armtune::internal
