#pragma once
// Computes a null-space motion, which moves the joints towards the middle of their limits without disturbing
// the task,
//   z = -k (q - middle).

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The motion z of every joint; zero for joints without position limits.
template <typename T>
struct JointCenteringT {
  JointVectorT<T> middle;  ///< middle of the position limits [rad, m]
  JointVectorT<T> rate;    ///< k [1/s]

  JointVectorT<T> velocity(const JointVectorT<T>& q) const {
    JointVectorT<T> z(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) z[i] = rate[i] * (middle[i] - q[i]);
    return z;
  }
  JointVectorT<T> acceleration(const JointVectorT<T>& qd) const {
    JointVectorT<T> z(qd.size());
    for (Eigen::Index i = 0; i < qd.size(); ++i) z[i] = -(rate[i] * qd[i]);
    return z;
  }
};
using JointCentering = JointCenteringT<double>;

/// Makes the motion for a model. rate: k [1/s] of joints with position limits.
JointCentering joint_centering(const RobotModel& model, double rate);

}  // namespace armtune::internal
