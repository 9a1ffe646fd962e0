#pragma once
// Fits the parameters of an arm to logged torques, and measures how well the fitted arm explains them. The
// fit keeps the links close to those of the robot file, but leaves rotor inertia and friction almost free.
// log_mistakes.hpp corrects possible mistakes in a log, and compares the corrections by this measure. If a
// correction changes only the torques (their order, scale or sign), the moments of the regressor are used
// again. If it changes the motion, they are computed again.

#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/identification/log_instants.hpp"
#include "tuner/identification/physical_cone.hpp"

namespace armtune::internal {

/// The second moments of the regressor's rows and of all logged torques, for one interpretation of the logged
/// motion.
struct ArmMoments {
  std::vector<Eigen::MatrixXd> YtY;               ///< [joint]: 13 n x 13 n, mean over the instants
  std::vector<std::vector<Eigen::VectorXd>> YtT;  ///< [joint][torque column]: 13 n
  Eigen::VectorXd torque_squares;                 ///< mean square of every torque column (n) [N^2 m^2, N^2]
};

ArmMoments arm_moments(const Chain& chain, const std::vector<LogInstant>& instants);

/// An interpretation of the logged torques: the torque of joint j is factor[j] * scale * torque column
/// column[j].
struct TorqueReading {
  std::vector<int> column;
  JointVector factor;  ///< of every joint, such as -1 (n)
  double scale = 1.0;  ///< of all joints

  static TorqueReading as_logged(int joints);
};

struct ArmFit {
  JointVector residual;  ///< RMS of every joint's unexplained torque beyond its noise (n) [N m, N]
  /// Residual of every joint (n), divided by the largest of these three: the RMS of its torque, the RMS of
  /// the torque that the robot file predicts, and half a percent of its effort limit. 0 to about 1.
  JointVector unexplained;
  /// Weighted sum of the squares of `unexplained` and of the links' changes from the robot file. Less is
  /// better.
  double cost = 0.0;
};

/// Fits physically valid arms to moments.
class ArmFitter {
 public:
  /// noise (n): standard deviation of the torques' noise, which no parameters can explain [N m, N].
  ArmFitter(const RobotModel& model, const JointVector& noise);

  /// Fits all parameters. Links that differ from those of the robot file add to the cost.
  ArmFit fit(const ArmMoments& moments, const TorqueReading& reading) const;
  /// Fits rotor inertia and friction only, with the robot file's own links.
  ArmFit fit_joints_only(const ArmMoments& moments, const TorqueReading& reading) const;

 private:
  ArmFit fit(const ArmMoments& moments, const TorqueReading& reading, double link_weight) const;

  ParameterVector prior_;
  JointVector noise_;
  JointVector least_torque_;  ///< a torque below this may be sensor noise [N m, N]
  PhysicalCone cone_;
  Eigen::MatrixXd link_metric_;
  Eigen::MatrixXd joint_metric_;
};

}  // namespace armtune::internal
