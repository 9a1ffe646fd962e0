#pragma once
// What happened in a rollout that a plan can be compared with: target switches, returns, laps.

#include <string>
#include <vector>

#include "core/control/state_machine.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

enum class EventKind {
  kSwitch,  ///< reached: s from the switch until the gaze is under its threshold and stays there
  kReturn,  ///< reached: s from leaving the last state until the path is followed again
  kLap,     ///< reached: rms of the gaze angle over one turn of the path [rad]
};
std::string name(EventKind kind);
/// Of what is reached.
std::string unit(EventKind kind);

/// What became of it.
enum class EventOutcome {
  kReached,
  kAlreadyThere,  ///< there was nothing to reach: 0 s
  kNotReached,    ///< the next switch came first
  kCutByEnd,      ///< the rollout ended first
  kCutByState,    ///< the controller turned to something else first: an obstacle
};
/// In a reader's words.
std::string words(EventOutcome outcome);

struct Event {
  EventKind kind = EventKind::kSwitch;
  EventOutcome outcome = EventOutcome::kReached;
  double time = 0.0;     ///< when it begins [s]
  double end = 0.0;      ///< what ended it at the latest: next switch, end of rollout, state or turn [s]
  double reached = 0.0;  ///< NaN: not before its end
  ControlState state = ControlState::kFollowTrajectory;  ///< in charge when it begins
  /// kSwitch: until the gaze is under its threshold for good, whatever state is in charge, or until the next
  /// switch or the end [s]: what reacquisition/time is the largest of.
  double settled = 0.0;
  double gaze = 0.0;     ///< angle to the active target at its beginning [rad]
  JointVector position;  ///< (n) at its beginning [rad, m]
  JointVector velocity;
  /// Largest distance of the tool from the path along an axis meanwhile [m]. Of a switch: as long as a plan
  /// for it lasts, which is until it was reached and kSwitchHold beyond; to its end if it was not.
  double path_error = 0.0;
  /// Least distance of a joint or the tool from an obstacle's surface at the same times [m]; infinite without
  /// obstacles.
  double nearest = 0.0;
  std::vector<double> times;  ///< kLap: of the rows that its rms is over [s]
};

/// A planned switch counts if the gaze stays on target so long [s].
inline constexpr double kSwitchHold = 0.5;

/// In order of time. rollout: rollout_<scenario>.csv, in whose rows times are counted; gaze_threshold: below
/// it a target counts as acquired [rad]. A switch that begins while the path is followed is judged for as
/// long as it is; one that begins on the way back to it, or aside of an obstacle, until the next. Those
/// before the path is first reached are left out, and so are turns that are not whole. Throws InputError if a
/// column is missing.
std::vector<Event> events_of(const CsvTable& rollout, const Scenario& scenario, double gaze_threshold);

}  // namespace armtune::internal
