#pragma once
// Finds whether measured torques are late, early or low-pass filtered against the motion. Each joint's
// measured torque is regressed on the model's torque, friction, rotor inertia and an offset. Each candidate
// delays or filters these in another way. The candidate with the smallest residuals is the most likely one.

#include "tuner/validation/torque_rows.hpp"

namespace armtune::internal {

struct TorqueTiming {
  double delay = 0.0;  ///< of the measured torques [s]; below zero: they are early
  double delay_gain =
      1.0;  ///< geometric mean over the joints: residual RMS with this delay over that without
  double time_constant = 0.0;  ///< of a first-order low-pass filter on the measured torques [s]
  double filter_gain = 1.0;    ///< as delay_gain, with this filter
};

/// Searches delays of up to 0.3 s in both directions and time constants of up to 0.5 s.
TorqueTiming torque_timing(const TorqueRows& rows);

}  // namespace armtune::internal
