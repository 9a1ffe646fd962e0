#pragma once
// Evaluates the unfitted model along a measured motion. Every row holds, for one joint and one instant, the
// measured torque, the torque that the model predicts by inverse dynamics, and how this torque changes with
// quantities that a robot file may have wrong: friction, rotor inertia, a payload, the direction of gravity.
// All columns pass the same second filter as the measured torque (parallel_filter.hpp).

#include <vector>

#include "tuner/validation/joint_motion.hpp"

namespace armtune::internal {

/// The columns of a row. The torque of the model changes by a column times the change of the quantity.
enum TorqueColumn : int {
  kMeasuredTorque,   ///< [N m, N]
  kPredictedTorque,  ///< inverse dynamics of the unfitted model, with its rotor inertia and friction [N m, N]
  kGravityTorque,    ///< the part of it that holds the arm still [N m, N]
  kJointVelocity,    ///< q' [rad/s, m/s]; also the change with viscous friction
  kJointAcceleration,  ///< q'' [rad/s^2, m/s^2]; also the change with rotor inertia
  kCoulombDirection,   ///< tanh(q'/0.05); the change with Coulomb friction
  kPayloadMass,        ///< the change with a mass at the origin of the last link's body frame [N m/kg, N/kg]
  kPayloadMomentX,  ///< the change with this mass's first moment in the last link's body frame [m/s^2, 1/s^2]
  kPayloadMomentY,
  kPayloadMomentZ,
  kGravityX,  ///< the change with gravity along x of the base frame [kg m, kg]
  kGravityY,
  kGravityZ,
  kTorqueColumns
};

/// The torques at the higher rate, before the second filter, for what depends on short instants.
struct WideTorques {
  double begin = 0.0;                            ///< time of the first row [s]
  double period = 0.0;                           ///< time between rows [s]
  Eigen::MatrixXd measured, predicted, qd, qdd;  ///< M x n
};

struct TorqueRows {
  double period = 0.0;                 ///< time between rows [s]; that of the first stretch
  std::vector<double> time;            ///< [s]
  std::vector<Eigen::MatrixXd> joint;  ///< [joint]: rows x kTorqueColumns
  std::vector<Eigen::VectorXd> q;      ///< positions of every row (n) [rad, m]
  std::vector<WideTorques> wide;       ///< one for every stretch of the motion

  Eigen::Index count() const { return static_cast<Eigen::Index>(time.size()); }
};

/// Evaluates the columns of one instant: n x kTorqueColumns. kMeasuredTorque is copied from the motion.
Eigen::MatrixXd torque_columns(const RobotModel& model, const FilteredMotion& motion);

/// Evaluates all rows of a motion. There is at least one row if the motion comes from joint_motion().
TorqueRows torque_rows(const RobotModel& model, const LoggedMotion& motion);

}  // namespace armtune::internal
