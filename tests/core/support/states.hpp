#pragma once
// Random states of an arm from a named generator, and kernels as plain functions of the state.

#include <Eigen/Geometry>
#include <random>

#include "core/robot/dynamics.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal::test {

inline double random_number(std::mt19937& generator, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(generator);
}

/// n numbers of at most `bound`.
inline JointVector random_vector(std::mt19937& generator, int n, double bound) {
  JointVector v(n);
  for (int i = 0; i < n; ++i) v[i] = random_number(generator, -bound, bound);
  return v;
}

inline Vec3 random_vec3(std::mt19937& generator, double bound) {
  return random_vector(generator, 3, bound);
}

/// Any orientation: the axis is never zero.
inline Eigen::Quaterniond random_orientation(std::mt19937& generator) {
  const Vec3 axis = random_vec3(generator, 1.0) + Vec3(0.0, 0.0, 1e-3);
  return Eigen::Quaterniond(Eigen::AngleAxisd(random_number(generator, -M_PI, M_PI), axis.normalized()));
}

/// Joint positions within the limits, or within 3 rad where there are none.
inline JointVector random_configuration(std::mt19937& generator, const RobotModel& arm) {
  JointVector q(arm.n());
  for (int i = 0; i < arm.n(); ++i) {
    const JointLimits& limits = arm.joints[static_cast<std::size_t>(i)].limits;
    q[i] = limits.has_position ? random_number(generator, limits.lower, limits.upper)
                               : random_number(generator, -3.0, 3.0);
  }
  return q;
}

inline Poses poses_at(const Chain& chain, const JointVector& q) {
  Poses poses;
  forward_kinematics(chain, q, poses);
  return poses;
}

inline Jacobian tool_jacobian_at(const Chain& chain, const JointVector& q) {
  Jacobian J;
  tool_jacobian(chain, poses_at(chain, q), J);
  return J;
}

inline JointMatrix mass_matrix_at(const Chain& chain, const JointVector& q) {
  JointMatrix M;
  mass_matrix(chain, poses_at(chain, q), M);
  return M;
}

inline JointVector inverse_dynamics_at(const Chain& chain, const JointVector& q, const JointVector& qd,
                                       const JointVector& qdd) {
  JointVector tau;
  inverse_dynamics(chain, poses_at(chain, q), qd, qdd, tau);
  return tau;
}

inline JointVector gravity_torque_at(const Chain& chain, const JointVector& q) {
  JointVector tau;
  gravity_torque(chain, poses_at(chain, q), tau);
  return tau;
}

/// Fv q' + Fc tanh(q' / 0.05), written out.
inline JointVector friction_at(const Chain& chain, const JointVector& qd) {
  return chain.viscous_friction.cwiseProduct(qd) +
         chain.coulomb_friction.cwiseProduct((qd / 0.05).array().tanh().matrix());
}

/// The same arm without joint friction.
inline Chain without_friction(Chain chain) {
  chain.viscous_friction.setZero();
  chain.coulomb_friction.setZero();
  return chain;
}

}  // namespace armtune::internal::test
