#include "tuner/validation/validation_thresholds.hpp"

namespace armtune::internal {

const std::array<ValidationThresholdField, 30>& validation_threshold_fields() {
  using T = ValidationThresholds;
  static const std::array<ValidationThresholdField, 30> fields = {{
      {"explained", "", "least share of a joint's torque variance that a matching model explains",
       &T::explained},
      {"negligible", "", "RMS residual that always matches, as a share of the effort limit", &T::negligible},
      {"cause_share", "", "least share of a joint's residual that one cause explains alone", &T::cause_share},
      {"cause_torque", "", "least RMS torque of a cause, as a share of its joint's torque", &T::cause_torque},
      {"tilt", "deg", "reported error of the direction of gravity", &T::tilt},
      {"gravity", "", "largest relative error of the size of a fitted gravity", &T::gravity},
      {"slow", "rad/s, m/s", "speed of all joints up to which only gravity is compared", &T::slow},
      {"reversal_speed", "rad/s, m/s", "speed on both sides of a reversal", &T::reversal_speed},
      {"reversal_window", "s", "time on each side of a reversal", &T::reversal_window},
      {"velocity_scale", "", "largest error of the slope of measured on differentiated velocity",
       &T::velocity_scale},
      {"velocity_error", "", "largest RMS difference of these velocities, as a share of their RMS",
       &T::velocity_error},
      {"moving", "rad/s, m/s", "least RMS speed at which velocities are compared", &T::moving},
      {"time_offset", "s", "reported time offset between channels", &T::time_offset},
      {"offset_gain", "", "factor on the residual below which a time offset is believed", &T::offset_gain},
      {"filter_time", "s", "reported time constant of a filter on the torques", &T::filter_time},
      {"clipped_share", "", "reported share of a torque's samples at one extreme value", &T::clipped_share},
      {"frozen_time", "s", "time for which a channel of a moving joint may keep one value", &T::frozen_time},
      {"jump_speed", "", "reported speed between two samples, as a multiple of the limit", &T::jump_speed},
      {"jump_size", "rad, m", "least reported jump of a position between two samples", &T::jump_size},
      {"gap", "", "time between two samples that counts as a gap, in sampling periods", &T::gap},
      {"frozen_share", "", "share of the log that a frozen channel may last before signs are not judged",
       &T::frozen_share},
      {"loaded", "", "RMS predicted torque of a joint under load, as a share of the effort limit",
       &T::loaded},
      {"other_arm", "", "slope of torque over predicted torque, or its reciprocal, of another arm",
       &T::other_arm},
      {"outside_limits", "", "position, as a multiple of its limit, that suggests degrees",
       &T::outside_limits},
      {"torque_horizon", "s", "time ahead by which motions under torque commands are judged",
       &T::torque_horizon},
      {"torque_motion", "", "largest position error then, as a share of that without a model",
       &T::torque_motion},
      {"drive_horizon", "s", "time ahead by which motions under other commands are judged",
       &T::drive_horizon},
      {"drive_motion", "", "largest position error then, as a share of that without a model",
       &T::drive_motion},
      {"drift", "rad/s, m/s", "RMS position error per time ahead that always matches", &T::drift},
      {"failed_windows", "", "largest share of simulated windows that diverge", &T::failed_windows},
  }};
  return fields;
}

}  // namespace armtune::internal
