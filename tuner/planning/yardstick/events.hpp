#pragma once
// What happened in a rollout that a plan can be held against: target switches, returns, laps.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "tuner/report/csv_table.hpp"

namespace armtune {

enum class EventKind {
  kSwitch,  ///< reached: s from the switch until the gaze is under its threshold and stays there
  kReturn,  ///< reached: s from leaving the last state until the path is followed again
  kLap,     ///< reached: rms of the gaze angle over one turn of the path [rad]
};
std::string name(EventKind kind);
/// Of what is reached.
std::string unit(EventKind kind);

struct Event {
  EventKind kind = EventKind::kSwitch;
  double time = 0.0;     ///< when it begins [s]
  double end = 0.0;      ///< when it is over: the next event of its kind, or what it ended with [s]
  double reached = 0.0;  ///< NaN: not before its end
  JointVector position;  ///< (n) at its beginning [rad, m]
  JointVector velocity;
  double path_error = 0.0;  ///< largest distance of the tool from the path along an axis meanwhile [m]
};

/// In order of time. rollout: rollout_<scenario>.csv; gaze_threshold: below it a target counts as acquired
/// [rad]. Events that begin while the path is not followed are left out. Throws InputError if a column is
/// missing.
std::vector<Event> events_of(const report::CsvTable& rollout, const Scenario& scenario,
                             double gaze_threshold);

}  // namespace armtune
