#include "tests/core/support/controller_rig.hpp"

#include <Eigen/Cholesky>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal::test {
namespace {

JointVector six(double a, double b, double c, double d, double e, double f) {
  JointVector v(6);
  v << a, b, c, d, e, f;
  return v;
}

JointVector acceleration(const Chain& chain, const JointVector& torque, const JointState& x) {
  JointMatrix M = mass_matrix_at(chain, x.q);
  M.diagonal() += chain.rotor_inertia;
  const JointVector h = inverse_dynamics_at(chain, x.q, x.qd, JointVector::Zero(chain.n));
  return M.llt().solve(torque - h);
}

}  // namespace

Gains ur10_gains() {
  Gains gains;
  gains.joint_space_gains_p = six(5, 8, 8, 10, 1, 1);
  gains.joint_space_gains_d = six(100, 75, 75, 15, 15, 5);
  gains.joint_space_goal = six(20, -90, -90, -90, 90, 0);
  gains.joint_trajectory_duration = 0.5;
  gains.task_space_gains_p << 8, 5, 5, 6, 5, 3;
  gains.task_space_gains_i << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  gains.task_space_gains_d = six(120, 110, 100, 25, 15, 5);
  gains.force_control_gains = six(10, 40, 10, 20, 15, 10);
  return gains;
}

Rig::Rig() : model(std::make_shared<const RobotModel>(ur10())), gains(ur10_gains()) {
  const Poses poses = poses_at(model->chain, goal().q);
  path = {poses.p_0T, 0.0, 0.0, {}};
  p_0G = poses.p_0T + 0.5 * poses.R_0T.col(2);
}

JointState Rig::goal() const {
  return {gains.joint_space_goal * (M_PI / 180.0), JointVector::Zero(6)};
}

std::unique_ptr<Controller> Rig::controller(const ParameterVector& theta) const {
  return std::make_unique<Controller>(model, gains, theta, period);
}

std::unique_ptr<Controller> Rig::controller() const {
  return controller(theta_of(model->chain));
}

std::unique_ptr<Controller> Rig::following(double& time) const {
  std::unique_ptr<Controller> result = controller();
  result->update(goal(), scene(), 0.0);
  for (time = gains.joint_trajectory_duration; time < 100.0; time += period) {
    if (result->update(goal(), scene(), time).state == ControlState::kFollowTrajectory) break;
  }
  time += period;
  return result;
}

std::vector<Obstacle> obstacles_near(const Rig& rig) {
  const Poses poses = poses_at(rig.model->chain, rig.goal().q);
  return {{poses.p_0B[2] + Vec3(0.1, 0.1, 0.0)}, {poses.p_0B[4] + Vec3(0.0, 0.1, 0.1)}};
}

void integrate(const Chain& chain, const JointVector& torque, double period, int substeps,
               JointState& state) {
  const double h = period / substeps;
  for (int step = 0; step < substeps; ++step) {
    const auto ahead = [&](double dt, const JointState& slope) {
      return JointState{state.q + dt * slope.q, state.qd + dt * slope.qd};
    };
    const auto slope_at = [&](const JointState& x) {
      return JointState{x.qd, acceleration(chain, torque, x)};
    };
    const JointState k1 = slope_at(state);
    const JointState k2 = slope_at(ahead(0.5 * h, k1));
    const JointState k3 = slope_at(ahead(0.5 * h, k2));
    const JointState k4 = slope_at(ahead(h, k3));
    state.q += h / 6.0 * (k1.q + 2.0 * k2.q + 2.0 * k3.q + k4.q);
    state.qd += h / 6.0 * (k1.qd + 2.0 * k2.qd + 2.0 * k3.qd + k4.qd);
  }
}

}  // namespace armtune::internal::test
