#pragma once
// Simulates several versions of an arm ahead under the logged commands, side by side in lanes
// (sim/lanes/arm_lanes.hpp). The versions differ in parameters or in the state at the start, so that
// differences of their positions are the sensitivities of the motion.

#include <memory>
#include <span>

#include "sim/lanes/arm_lanes.hpp"
#include "tuner/calibration/calibration_windows.hpp"
#include "tuner/calibration/shooting_arm.hpp"

namespace armtune::internal {

/// The state of an arm at the start of a window.
struct StartState {
  JointVector q;         ///< logged position, without the noise of encoders (n) [rad, m]
  JointVector qd;        ///< (n) [rad/s, m/s]
  JointVector integral;  ///< torque of the drives' integrals (n) [N m, N]; unused without drives
};

/// The commands in the steps of a window, for one delay. Without drives `feed` are torques. With drives it is
/// the velocity that they follow, and `position` the logged position towards which the position loop pulls.
struct StepCommands {
  Eigen::MatrixXd feed;      ///< steps x n
  Eigen::MatrixXd position;  ///< steps x n; empty without a position loop
};

/// One version of the arm, its start, and the commands with its delay. All must outlive the simulation.
struct Shot {
  const ShootingArm* arm = nullptr;
  const StartState* start = nullptr;
  const StepCommands* commands = nullptr;
};

class Shooting {
 public:
  /// commands: those of one of the logs. All logs have the same kind of commands, the same servo and the same
  /// rate.
  Shooting(const RobotModel& nominal, const MotionCommands& commands);
  ~Shooting();

  double step() const { return step_; }  ///< of the simulation [s]

  /// Returns the commands in a window of a log for a delay [s].
  StepCommands step_commands(const CommandSignal& signal, const JointLog& log, const LogWindow& window,
                             double delay) const;

  /// Simulates all shots. Returns for each the logged positions that it predicts at the window's samples, as
  /// one column of window.count x n numbers, sample by sample. A position that is not finite, or more than
  /// kFar from the start, is replaced by the distance kFar.
  Eigen::MatrixXd simulate(const JointLog& log, const LogWindow& window, std::span<const Shot> shots);

  static constexpr double kFar = 10.0;  ///< [rad, m]

 private:
  struct Lane;
  Eigen::Index steps_in(const JointLog& log, const LogWindow& window) const;
  void place(int lane, const Chain& chain, const JointVector& q, const JointVector& qd);
  void start(int lane, const Shot& shot);
  void push(int lane, Eigen::Index step);

  RobotModel nominal_;
  CommandKind kind_;
  std::optional<ServoGains> servo_;
  double step_;
  bool holds_weight_ = false;  ///< the robot adds the torque that holds the weight of its own model
  std::unique_ptr<ArmLanes> arms_;
  std::vector<Lane> lanes_;
};

}  // namespace armtune::internal
