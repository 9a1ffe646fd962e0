#pragma once
// How well some arm near the robot file's explains logged torques, whatever its friction: the measure by
// which possible mistakes in a log are compared. Torques may be permuted, turned in sign or scaled after the
// regressor has been formed; what changes the motion needs new moments.

#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/identification/log_instants.hpp"
#include "tuner/identification/physical_cone.hpp"

namespace armtune::internal {

/// Second moments of the regressor's rows and of all logged torques, of one reading of the motion.
struct ArmMoments {
  std::vector<Eigen::MatrixXd> YtY;               ///< [joint]: 13 n x 13 n, mean over the instants
  std::vector<std::vector<Eigen::VectorXd>> YtT;  ///< [joint][torque column]: 13 n
  Eigen::VectorXd torque_squares;                 ///< of every torque column (n), mean [N^2 m^2, N^2]
};

ArmMoments arm_moments(const Chain& chain, const std::vector<LogInstant>& instants);

/// How the logged torques are read: joint j's is sign[j] scale torque column column[j].
struct TorqueReading {
  std::vector<int> column;
  JointVector sign;
  double scale = 1.0;

  static TorqueReading as_logged(int joints);
};

struct ArmFit {
  JointVector residual;  ///< of every joint (n): RMS of what is left of the torque beyond its noise [N m, N]
  /// Of every joint (n): RMS of what is left over the RMS of the torque, of what the robot file expects, or
  /// half a percent of the effort limit, whichever is largest; 0 to about 1.
  JointVector unexplained;
  double distance = 0.0;  ///< RMS over the links of how far each is from the robot file's, relative
  double cost = 0.0;      ///< sum of both squares, weighted: the smaller the more likely
};

/// Fits physically valid arms to moments.
class ArmFitter {
 public:
  /// noise (n): standard deviation of the torques' noise, which no arm explains [N m, N].
  ArmFitter(const RobotModel& model, const JointVector& noise);

  ArmFit fit(const ArmMoments& moments, const TorqueReading& reading) const;
  /// The same for the robot file's own links: only rotor inertia and friction are fitted.
  ArmFit fit_joints_only(const ArmMoments& moments, const TorqueReading& reading) const;

 private:
  ArmFit fit(const ArmMoments& moments, const TorqueReading& reading, double link_weight) const;

  ParameterVector prior_;
  JointVector noise_;
  JointVector least_torque_;  ///< below it a torque may be the sensor's noise [N m, N]
  PhysicalCone cone_;
  Eigen::MatrixXd link_metric_;
  Eigen::MatrixXd joint_metric_;
};

}  // namespace armtune::internal
