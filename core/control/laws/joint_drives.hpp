#pragma once
// The inner loops of robots that take joint velocities or joint positions instead of torques. They run inside
// the robot, usually faster than the controller whose commands they follow.

#include <optional>

#include "core/common/delay_line.hpp"
#include "core/control/control_output.hpp"
#include "core/control/laws/drive_output.hpp"
#include "core/control/laws/position_servo.hpp"
#include "core/control/laws/velocity_drive.hpp"

namespace armtune::internal {

/// Rate of the drives unless another one is given [Hz].
inline constexpr double kDriveFrequency = 1000.0;
/// Returns the lowest rate of the robot's drives [Hz]: the one of its file, else plant_rate, which a scenario
/// gives, else kDriveFrequency. A rate of 0 means that none is given.
inline double drive_frequency(const RobotModel& robot, double plant_rate) {
  if (robot.drive_rate > 0.0) return robot.drive_rate;
  return plant_rate > 0.0 ? plant_rate : kDriveFrequency;
}

/// Gain of the drives' position loops if the robot's file gives none [1/s]: a quarter of kDriveRate.
inline constexpr double kDrivePositionGain = 0.25 * kDriveRate;

/// The times of a robot's drives.
struct DriveTiming {
  double frequency = kDriveFrequency;  ///< lowest rate of the drives [Hz]
  int delay = 0;                       ///< control periods that a command takes to reach the drives
};

/// Returns the smallest number of equal steps, at least one, into which a period [s] must be divided for
/// steps at no less than this frequency [Hz].
int steps_in(double period, double frequency);

/// The velocity drives of all joints, and for robots that take positions also the loops in front of them. At
/// the start they hold the arm's weight: the integrals of the velocity drives are set to the torque that
/// holds the arm. If the robot compensates gravity (RobotModel::compensates_gravity), these integrals start
/// at zero instead, and the gravity torque of each control period is added to the drives' torque. The limit
/// of the torque's rate and the delay act on the whole torque (drive_output.hpp).
class JointDrives {
 public:
  /// Drives that take velocities. period: control period [s].
  JointDrives(const RobotModel& model, double period, const DriveTiming& timing);
  /// Drives that take positions. A servo turns the commanded positions into a smooth motion q_s. The velocity
  /// drives follow
  ///   q_s' + position_gain * (q_s - q).
  /// The first term is the mean over a period of the drives. position_gain [1/s]: used for every joint if the
  /// robot's file gives no gains. If it does, its gains are multiplied by position_gain / kDrivePositionGain.
  JointDrives(const RobotModel& model, double period, const DriveTiming& timing, const ServoGains& servo,
              double position_gain);

  /// Number of the drives' periods in a control period. They have equal length.
  int steps() const { return steps_; }
  /// True if the next call of begin() uses the weight.
  bool needs_weight() const { return robot_holds_ || !begun_; }

  /// Begins a control period with the controller's command (n), which reaches the drives after the delay.
  /// Until the first command arrives, the drives are commanded to stand still. measured: the joints at this
  /// time. weight (n): torque that holds the arm, used if needs_weight() is true. Allocates nothing.
  void begin(const JointVector& command, const JointState& measured, const JointVector& weight);
  /// Computes the torques tau (n) [N m, N] of the next period of the drives. Allocates nothing.
  void torque(const JointState& measured, JointVector& tau);
  /// Sets the torques (n) that next() adds: the repulsion of obstacles and the torque of the velocity
  /// barrier. commanded: the sum of these and of the last result of torque().
  void keep_added(const JointVector& commanded) { added_ = commanded - torque_; }
  /// Computes the torques (n) of the next period, with those that keep_added() set for the control period:
  /// before saturation, and within the effort limits. Allocates nothing.
  void next(const JointState& measured, JointVector& commanded, JointVector& torque);

 private:
  int steps_;
  double step_;  ///< period of the drives [s]
  bool robot_holds_;
  JointVector effort_;  ///< effort limits
  JointVector position_gain_;
  std::optional<PositionServo> servo_;
  VelocityDrives drives_;
  DelayLine delay_;
  DriveOutput output_;
  bool begun_ = false;       ///< there was a control period before
  JointVector commanded_;    ///< the command that acts now
  JointVector velocity_;     ///< command for the velocity drives
  JointVector held_weight_;  ///< added to their torque
  JointVector torque_;       ///< the last result of torque()
  JointVector added_;        ///< to the torque, by repulsion and velocity barrier
};

}  // namespace armtune::internal
