#pragma once
// Fits what a user cannot look up to logs of encoders and commands: friction, rotor inertia, delay, gains of
// drives, payload, direction of gravity and encoder offsets. Torques are not needed.
//
//     const Calibration found = calibrate(*load_robot("ur5e"), logs);
//     write(calibrated_robot_yaml(*load_robot("ur5e"), found, "robot.urdf"));

#include <atomic>

#include "tuner/calibration/held_out_error.hpp"

namespace armtune::internal {

/// A motion from whose log a parameter could be told.
enum class CalibrationNeed {
  kNone,              ///< the log tells the parameter
  kReversals,         ///< the joint reverses often, at low speed
  kSteadySpeeds,      ///< the joint moves at several steady speeds up to its limit
  kAccelerations,     ///< the joint accelerates strongly, back and forth
  kChangingCommands,  ///< commands change fast, and joints accelerate and reverse
  kPoses,             ///< the arm passes many poses, with each link in several directions to gravity
  kOutside            ///< no motion tells it: an instrument outside the arm does
};

/// Returns the name of a need, such as "reversals".
const char* name(CalibrationNeed need);
/// Returns what the motion must contain, as the rest of a sentence.
const char* meaning(CalibrationNeed need);

struct FittedParameter {
  CalibrationParameter prior;
  double value = 0.0;  ///< most probable value, in the unit of `prior`; the prior pulls it if it is not told
  double low = 0.0;    ///< 95 % interval
  double high = 0.0;
  double spread = 1.0;  ///< standard deviation after the fit, relative to the prior's
  bool told = false;    ///< true if the log tells it: the spread is at most CalibrationOptions::told
  /// True if the calibrated arm keeps the robot file's value, because the log says next to nothing about it.
  bool kept = false;
  CalibrationNeed need = CalibrationNeed::kNone;
};

struct CalibrationOptions {
  CalibrationPriors priors;
  double told = 0.5;  ///< largest spread of a parameter that the log tells
  std::function<void(const char* phase, int iteration, double objective)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< true: calibrate() returns soon; must outlive the call
};

struct Calibration {
  CommandKind commands = CommandKind::kTorque;  ///< that moved the arm in the logs
  bool interrupted = false;                     ///< true: stopped early, and the other members are incomplete
  std::vector<FittedParameter> parameters;
  Eigen::VectorXd z;           ///< of all parameters, standardised (calibration_parameters.hpp)
  Eigen::MatrixXd covariance;  ///< of z
  /// The calibrated arm. Parameters about which the log says next to nothing, with a spread above 0.9, have
  /// the values of the robot file.
  ShootingArm arm;
  Eigen::VectorXd noise;  ///< of the encoders (n) [rad, m]
  ShootingFit fit;
  HeldOutError before, after;  ///< errors of the robot file's arm and of `arm`
};

/// Calibrates a model. All logs have the same kind of commands at the same rate. Throws InputError if there
/// is no log, if a log or its commands are malformed, if commands are references of a controller, if kinds or
/// rates differ, or if no held-out window reaches half a second ahead.
Calibration calibrate(const RobotModel& model, std::span<const CommandedLog> logs,
                      const CalibrationOptions& options = {});

}  // namespace armtune::internal
