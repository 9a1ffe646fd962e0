#pragma once
// Computes the motion of an arm's joints from a log: positions, velocities and accelerations without the
// sensors' noise and without delay. The filters are those of identification (parallel_filter.hpp), here the
// first of the two. Measured velocities are compared with the derivative of the positions. Where they agree,
// they are used, because their derivative has less noise than the second derivative of the positions.

#include <vector>

#include "tuner/identification/parallel_filter.hpp"
#include "tuner/validation/joint_log.hpp"

namespace armtune::internal {

/// How a measured velocity channel compares with the derivatives of the positions.
struct VelocityAgreement {
  double speed = 0.0;        ///< RMS of the derivative of the position [rad/s, m/s]
  double slope = 1.0;        ///< of measured on differentiated velocity, after the lag is removed
  double error = 0.0;        ///< RMS of measured minus differentiated velocity, as a share of `speed`
  double correlation = 1.0;  ///< of the two, after the lag is removed
  double lag = 0.0;          ///< time by which the measured velocity is late [s]
  int best_joint = -1;       ///< the joint whose differentiated position correlates best with this channel
  double best_correlation = 0.0;  ///< its correlation, with sign
  bool compared = false;          ///< false if the joint is too slow, or no velocities were measured
  bool used = false;              ///< true if the measured velocity is used instead of the derivative
};

/// A part of a log at a constant rate, after the first filter. The edges at both ends are left out.
struct MotionStretch {
  double begin = 0.0;          ///< time of the first instant [s]
  double period = 0.0;         ///< time between instants [s]
  double sample_period = 0.0;  ///< time between samples of the log [s]
  std::vector<FilteredMotion> instants;
};

struct LoggedMotion {
  double cutoff = 0.0;         ///< of the second filter [Hz]
  double sample_period = 0.0;  ///< median time between samples [s]
  double torque_norm = 1.0;    ///< norm of the weights of both filters (ParallelFilter::torque_norm)
  std::vector<MotionStretch> stretches;
  std::vector<VelocityAgreement> velocities;  ///< n
  std::vector<PositionJump> jumps;
};

/// Default cutoff of the second filter [Hz], that of identification.
inline constexpr double kValidationCutoff = 5.0;

/// Computes the motion. cutoff [Hz]: of the second filter; it is lowered to an eighth of the sampling rate if
/// need be. Throws InputError if the log is malformed (check_joint_log), or too short for the filters.
LoggedMotion joint_motion(const RobotModel& model, const JointLog& log,
                          const ValidationThresholds& thresholds = {}, double cutoff = kValidationCutoff);

}  // namespace armtune::internal
