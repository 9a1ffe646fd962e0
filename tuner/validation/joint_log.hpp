#pragma once
// A log of one arm's joints as numbers: times, positions and, if there are any, velocities and measured
// torques. It is what a validation reads, whatever file the numbers came from.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/validation/validation_thresholds.hpp"

namespace armtune::internal {

/// N samples of n joints, in the joint order of the robot model.
struct JointLog {
  std::string source;        ///< name of the log in messages
  std::vector<double> time;  ///< N, not decreasing [s]
  Eigen::MatrixXd q;         ///< N x n [rad, m]
  Eigen::MatrixXd qd;        ///< N x n [rad/s, m/s]; empty if no velocities were measured
  Eigen::MatrixXd torque;    ///< N x n [N m, N]; empty if no torques were measured

  bool has_velocities() const { return qd.size() > 0; }
  bool has_torques() const { return torque.size() > 0; }
  Eigen::Index samples() const { return static_cast<Eigen::Index>(time.size()); }
};

/// Throws InputError with the source, the channel as key, the value and the limit in each of these cases:
/// fewer than 20 samples, sizes that differ, numbers that are not finite, a time that decreases, times that
/// are all the same.
void check_joint_log(const RobotModel& model, const JointLog& log);

/// Returns the median time between samples with different times [s].
double sampling_period(const JointLog& log);

/// A jump of a position between two samples, such as a restart of the recording leaves.
struct PositionJump {
  int joint = -1;
  Eigen::Index sample = 0;  ///< the sample behind the jump
  double time = 0.0;        ///< its time [s]
  double size = 0.0;        ///< [rad, m]
};

/// Returns the first jumps, at most 100. A jump is a step of at least jump_size that is faster than
/// jump_speed times the joint's velocity limit, and five times as fast as 95 % of the joint's own steps.
std::vector<PositionJump> position_jumps(const RobotModel& model, const JointLog& log,
                                         const ValidationThresholds& thresholds);

/// A part of a log without gaps and jumps, at a constant rate.
struct UniformStretch {
  double begin = 0.0;             ///< time of the first sample [s]
  double period = 0.0;            ///< time between samples [s]
  Eigen::MatrixXd q, qd, torque;  ///< as in JointLog; torque is zero if none was measured
};

/// Divides a log at its gaps and jumps, and resamples each part at its mean rate: positions by cubic
/// interpolation, velocities and torques by linear interpolation. Samples with the time of the sample before
/// them are left out, and so are parts of fewer than 20 samples. The log must have passed check_joint_log().
std::vector<UniformStretch> uniform_stretches(const JointLog& log, const std::vector<PositionJump>& jumps,
                                              const ValidationThresholds& thresholds);

}  // namespace armtune::internal
