#pragma once
// An arm of one joint, whose closed loop a few lines can integrate once more.

#include "core/control/laws/controller_kind.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "tests/core/support/arms.hpp"

namespace armtune::internal::test {

/// One joint about a horizontal axis: q'' = (tau - m g l cos q - b q') / (J + rotor), with m = 3, l = 0.4,
/// J = 0.6, rotor = 0.2, b = 1.5.
inline RobotModel pendulum() {
  RobotModel arm = random_arm(1, 7, false);
  Chain& chain = arm.chain;
  chain.R_PB0[0] << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;  // its z is the base's -y
  chain.p_PB0[0].setZero();
  chain.gravity = Vec3(0.0, 0.0, -9.81);
  chain.link[0].mass = 3.0;
  chain.link[0].first_moment = Vec3(3.0 * 0.4, 0.0, 0.0);
  chain.link[0].inertia = Vec3(0.1, 0.6, 0.6).asDiagonal();
  chain.rotor_inertia[0] = 0.2;
  chain.viscous_friction[0] = 1.5;
  chain.coulomb_friction[0] = 0.0;
  arm.joints[0].limits = {true, -3.0, 3.0, 10.0, 1e4};
  return arm;
}

/// Gains of a controller that follows joint motions, for one joint; those of its law are to be set.
inline Gains one_joint_gains(const char* controller) {
  Gains gains;
  change_controller(gains, controller, 1);
  gains.joint_space_gains_p = gains.joint_space_gains_d = gains.joint_space_goal = JointVector::Zero(1);
  gains.joint_trajectory_duration = 1.0;
  gains.force_control_gains = JointVector::Zero(1);
  return gains;
}

/// Acceleration linear between the knots: 0.2 + 0.3 t^3 until 1 s, then 0.5 + 0.9 s + 0.9 s^2 - 0.6 s^3.
inline JointSpline one_joint_plan() {
  const auto at = [](double q, double v, double a) {
    return MotionPoint<JointVector>{JointVector::Constant(1, q), JointVector::Constant(1, v),
                                    JointVector::Constant(1, a)};
  };
  return JointSpline({0.0, 1.0, 2.0}, {at(0.2, 0.0, 0.0), at(0.5, 0.9, 1.8), at(1.7, 0.9, -1.8)});
}

/// q'' of the pendulum, written out.
inline double pendulum_acceleration(double tau, double q, double qd) {
  return (tau - 3.0 * 9.81 * 0.4 * std::cos(q) - 1.5 * qd) / (0.6 + 0.2);
}

/// q'' of an arm of one joint by its dynamics.
inline double joint_acceleration(const RobotModel& arm, double tau, double q, double qd) {
  Poses poses;
  forward_kinematics(arm.chain, JointVector(JointVector::Constant(1, q)), poses);
  ForwardDynamics work;
  JointVector qdd;
  forward_dynamics(arm.chain, poses, JointVector(JointVector::Constant(1, qd)),
                   JointVector(JointVector::Constant(1, tau)), work, qdd);
  return qdd[0];
}

/// A period of x'' = acceleration(x, v) in four steps of Runge-Kutta's fourth order.
template <typename Acceleration>
void integrate(const Acceleration& acceleration, double period, double& x, double& v) {
  for (int part = 0; part < 4; ++part) {
    const double h = period / 4.0;
    const double a1 = acceleration(x, v), v1 = v;
    const double a2 = acceleration(x + 0.5 * h * v1, v + 0.5 * h * a1), v2 = v + 0.5 * h * a1;
    const double a3 = acceleration(x + 0.5 * h * v2, v + 0.5 * h * a2), v3 = v + 0.5 * h * a2;
    const double a4 = acceleration(x + h * v3, v + h * a3), v4 = v + h * a3;
    x += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
}

}  // namespace armtune::internal::test
