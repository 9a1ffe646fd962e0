#pragma once
// A simulated arm that follows an exciting trajectory, and the log its sensors would give.

#include <atomic>

#include "sim/plant/stepper.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/identification/excitation.hpp"
#include "tuner/identification/log_file.hpp"

namespace armtune::internal {

struct ExcitationLogOptions {
  double torque_noise = 0.0;  ///< standard deviation, white, per sample [N m, N]
  bool payload = false;       ///< whether the scenario's payload hangs at the tool
  double bandwidth = 20.0;    ///< Kd = bandwidth times the joint's inertia at the centre [1/s]
  double stiffness = 5.0;     ///< Kp [1/s]
  Stepper stepper = Stepper::kMidpoint;
};

struct ExcitationLog {
  std::vector<LogSample> samples;  ///< one per control period, time from 0
  double tracking_error = 0.0;     ///< largest |q - qd| [rad, m]
  double velocity_ratio = 0.0;     ///< largest |q'| over its limit
  bool saturated = false;          ///< a torque reached its limit
  bool interrupted = false;
};

/// Takes the scenario's arm (noise, delay, friction, seed; not its task) from its start pose to the centre in
/// 3 s and along the trajectory, under tau = Y theta - Kd S with the model's theta. What is logged: measured
/// positions and velocities; torque as a sensor at the joint would give it, the mean of what acts before and
/// after the instant. Throws InputError if the arm cannot follow.
ExcitationLog simulate_excitation(const Scenario& scenario, const Excitation& excitation,
                                  const ExcitationLogOptions& options, const std::atomic<bool>& stop);

/// Text of the log as CSV, with the columns of `default_log_columns`. Numbers read back to the same bits.
std::string log_csv(const RobotModel& model, const ExcitationLog& log);

}  // namespace armtune::internal
