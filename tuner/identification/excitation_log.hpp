#pragma once
// Simulates an arm that follows an exciting trajectory (excitation.hpp), and returns the log that its sensors
// would record. Such a log serves to test an identification before the real arm is used.

#include <atomic>

#include "sim/plant/stepper.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/identification/excitation.hpp"
#include "tuner/identification/log_file.hpp"

namespace armtune::internal {

struct ExcitationLogOptions {
  double torque_noise = 0.0;  ///< standard deviation of the white noise per sample [N m, N]
  bool payload = false;       ///< true: the scenario's payload is attached to the tool
  double bandwidth = 20.0;    ///< Kd = bandwidth times the joint's inertia at the centre [1/s]
  double stiffness = 5.0;     ///< Kp [1/s]
  Stepper stepper = Stepper::kMidpoint;
};

struct ExcitationLog {
  std::vector<LogSample> samples;  ///< one per control period, time from 0
  double tracking_error = 0.0;     ///< largest difference of a joint position from the trajectory [rad, m]
  double velocity_ratio = 0.0;     ///< largest ratio of |q'| to its limit
  bool saturated = false;          ///< true if a torque reached its limit
  bool interrupted = false;
};

/// Simulates the scenario's arm with its noise, delay, friction and seed, but without its task. The arm moves
/// from its start pose to the centre in 3 s and then along the trajectory, under tau = Y * theta - Kd * S.
/// Here Y is the regressor, theta are the model's inertial and friction parameters, and S is the measured
/// velocity minus its reference, which includes Kp times the position error. The log has measured positions
/// and velocities. Its torques are those of joint torque sensors: the mean of the torques that act before and
/// after the instant. Throws InputError if the arm is more than 0.5 rad or 0.5 m off the trajectory.
ExcitationLog simulate_excitation(const Scenario& scenario, const Excitation& excitation,
                                  const ExcitationLogOptions& options, const std::atomic<bool>& stop);

/// Returns the log as CSV, with the columns of `default_log_columns`. Numbers have all digits that are needed
/// to read back the same value.
std::string log_csv(const RobotModel& model, const ExcitationLog& log);

}  // namespace armtune::internal
