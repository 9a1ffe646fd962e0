#pragma once
// The thresholds by which a log and a robot file count as matching. All of them are declared here, with unit
// and meaning, so that the command can print what its verdict is based on.

#include <array>

namespace armtune::internal {

struct ValidationThresholds {
  double explained = 0.9;      ///< share of a joint's torque variance that a matching model explains
  double negligible = 0.005;   ///< RMS residual that always counts as a match, as a share of the effort limit
  double cause_share = 0.05;   ///< share of a joint's residual that a cause explains beyond all other causes
  double cause_torque = 0.02;  ///< least RMS torque of a cause, as a share of the RMS torque of its joint
  double tilt = 3.0;           ///< error of the direction of gravity that is reported [deg]
  double gravity = 0.3;        ///< relative error of the size of a fitted gravity above which it is discarded
  double slow = 0.05;          ///< speed of all joints up to which an instant belongs to gravity [rad/s, m/s]
  double reversal_speed = 0.02;  ///< speed that a joint exceeds before and after a reversal [rad/s, m/s]
  double reversal_window = 0.3;  ///< time before and after a reversal whose residuals are compared [s]
  double velocity_scale = 0.05;  ///< difference from 1 of the slope of measured on differentiated velocity
  double velocity_error = 0.1;   ///< RMS difference of these velocities, as a share of their RMS
  double moving = 0.05;          ///< RMS speed from which a joint's velocities are compared [rad/s, m/s]
  double time_offset = 0.006;    ///< time offset between channels that is reported [s]
  double offset_gain = 0.8;      ///< factor on the residuals' RMS below which a time offset is believed
  double filter_time = 0.03;     ///< time constant of a filter on the torques that is reported [s]
  double clipped_share = 0.005;  ///< share of a channel's samples at the same extreme value
  double frozen_time = 0.5;      ///< time for which a channel of a moving joint may keep one value [s]
  double jump_speed = 3.0;       ///< speed between two samples, as a multiple of the joint's velocity limit
  double jump_size = 0.01;       ///< least jump of a position between two samples [rad, m]
  double gap = 5.0;              ///< time between two samples that counts as a gap, in sampling periods
  double frozen_share = 0.1;     ///< share of the log from which on a frozen channel spoils its other checks
  double loaded = 0.05;    ///< RMS predicted torque, as a share of the effort limit, of joints under load
  double other_arm = 0.6;  ///< slope of measured over predicted torque of loaded joints of another arm
  double outside_limits = 3.0;   ///< position, as a multiple of its limit, that suggests degrees
  double torque_horizon = 0.1;   ///< time ahead by which motions under torque commands are judged [s]
  double torque_motion = 0.5;    ///< RMS position error then, as a share of that without a model
  double drive_horizon = 1.0;    ///< as torque_horizon, under commands that drives or a controller follow [s]
  double drive_motion = 0.05;    ///< as torque_motion, at drive_horizon
  double drift = 0.002;          ///< RMS position error per time ahead that always matches [rad/s, m/s]
  double failed_windows = 0.05;  ///< share of the simulated windows that may diverge
};

/// One threshold: its name, unit, meaning and member.
struct ValidationThresholdField {
  const char* name;
  const char* unit;  ///< empty: a ratio
  const char* meaning;
  double ValidationThresholds::*value;
};

/// Returns every threshold, in the order of the structure.
const std::array<ValidationThresholdField, 30>& validation_threshold_fields();

}  // namespace armtune::internal
