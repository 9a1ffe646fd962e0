#pragma once
// The last stage of a joint drive. The torque that the drive has computed changes no faster than the drive
// allows, and it acts on the joint only after a delay.

#include <array>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Limits and delays the torques of all drives as the robot's file says (RobotModel::drive_torque_rate and
/// drive_delay). Without these values the torques pass unchanged.
class DriveOutput {
 public:
  /// period: of the drives [s].
  DriveOutput(const RobotModel& model, double period);

  /// Sets the torques (n) [N m, N] that act until those of the first period arrive. The rate limit applies to
  /// the change from these torques to those of the first period.
  void start(const JointVector& tau);
  /// Takes the torques (n) [N m, N] computed in this period of the drives and replaces them by those that act
  /// in it. If a delay is not a whole number of periods, the mean torque of the period acts. Allocates
  /// nothing.
  void pass(JointVector& tau);

 private:
  JointVector change_;                           ///< largest change of a torque in a period; empty: no limit
  JointVector effort_;                           ///< effort limits
  JointVector last_;                             ///< torque of the last period, before the delay
  std::array<std::size_t, kMaxJoints> whole_{};  ///< whole periods of each delay
  JointVector part_;                             ///< rest of each delay [periods]
  std::vector<JointVector> line_;                ///< ring buffer of computed torques; empty: no delay
  std::size_t next_ = 0;                         ///< slot of this period's torques
};

}  // namespace armtune::internal
