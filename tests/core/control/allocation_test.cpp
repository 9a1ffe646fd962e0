// No allocation inside a control period.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace allocation_test {

class Allocation : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  }
};

TEST_F(Allocation, IsSeenByTheCounterInNewAndInEigen) {
  const long before = test::allocations();
  const std::vector<double> numbers(100, 1.0);
  EXPECT_GT(test::allocations(), before) << numbers.size();
  const long between = test::allocations();
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(20, 20);
  EXPECT_GT(test::allocations(), between) << matrix.sum();
}

/// A rig whose path moves.
test::Rig moving_rig() {
  test::Rig rig;
  rig.gains.joint_trajectory_duration = 0.2;
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}, {2, Vec3(0, 0, 0.02), Vec3(0, 0, 0)}};
  return rig;
}

/// What happened in 1000 periods through all four states, with obstacles, slerps and a singularity.
struct Drive {
  std::array<int, 4> visits{};
  int slerps = 0;
  int damped = 0;
  int slowed = 0;
  int adapted = 0;
  long allocations = 0;

  /// wrist_speed [rad/s]: as measured of the last joint.
  Drive(const test::Rig& rig, const ParameterVector& theta, double wrist_speed) {
    const std::unique_ptr<Controller> controller = rig.controller(theta);
    const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
    const std::vector<Obstacle> near = {{poses.p_0B[2] + Vec3(0.1, 0.1, 0.0)},
                                        {poses.p_0B[4] + Vec3(0.0, 0.1, 0.1)}};
    const Vec3 elsewhere = rig.p_0G + Vec3(0.5, 0.3, 0.2);
    for (int step = 0; step < 1000; ++step) {
      Scene scene = rig.scene();
      if (step >= 600 && step < 700) scene.obstacles = near;
      if (step >= 800) scene.target.position = elsewhere;
      JointState measured = rig.goal();
      measured.qd[5] = wrist_speed;
      if (step >= 900 && step < 950) measured.q[4] = 0.0;  // the wrist's singularity: the damped inverse
      const ParameterVector before_theta = controller->theta();
      const long before = test::allocations();
      const ControlOutput& out = controller->update(measured, scene, step * rig.period);
      allocations += test::allocations() - before;
      ++visits[static_cast<std::size_t>(out.state)];
      slerps += out.slerping ? 1 : 0;
      damped += out.damped ? 1 : 0;
      slowed += out.pace < 1.0 ? 1 : 0;
      adapted += controller->theta() != before_theta ? 1 : 0;
    }
  }
};

void expect_none_anywhere(const Drive& drive) {
  EXPECT_EQ(drive.allocations, 0);
  for (std::size_t state = 0; state < drive.visits.size(); ++state) {
    EXPECT_GT(drive.visits[state], 50) << name(static_cast<ControlState>(state));
  }
  EXPECT_GT(drive.slerps, 50);
  EXPECT_GT(drive.damped, 40);
  EXPECT_GT(drive.adapted, 100);
}

TEST_F(Allocation, NeverHappensInUpdateInAnyStateWithObstaclesAndSlerps) {
  const test::Rig rig = moving_rig();
  const Drive drive(rig, theta_of(rig.model->chain), 0.0);
  expect_none_anywhere(drive);
  EXPECT_EQ(drive.slowed, 0);
}

TEST_F(Allocation, NeverHappensWithEveryOptionOn) {
  for (const SlerpReference reference : {SlerpReference::kStart, SlerpReference::kCurrent}) {
    test::Rig rig = moving_rig();
    Gains& gains = rig.gains;
    gains.slerp_reference = reference;
    gains.gaze_feedforward = true;
    gains.joint_goal_follows_task = true;
    gains.velocity_margin = 0.3;
    gains.velocity_barrier_start = 0.5;
    gains.velocity_barrier_gain = 1.0;
    gains.adaptation_leakage = 0.1;
    gains.adaptation_inertia_leakage = 0.1;
    gains.adaptation_filter = reference == SlerpReference::kStart ? 5.0 : 0.0;
    gains.roll_centering_gain = 0.2;
    gains.adaptation_projection = true;
    // From nothing: the projection has work in most periods.
    const ParameterVector nothing = ParameterVector::Zero(parameter_count(rig.model->chain));
    const double fast = 0.7 * rig.model->velocity_limits()[5];
    const Drive drive(rig, nothing, fast);
    expect_none_anywhere(drive);
    EXPECT_GT(drive.slowed, 50);
  }
}

TEST_F(Allocation, NeverHappensUnderAnyController) {
  for (const ControllerKind* kind : controller_kinds()) {
    test::Rig rig = moving_rig();
    rig.gains = convert_gains(*kind, rig.gains, *rig.model, rig.goal().q);
    const Drive drive(rig, theta_of(rig.model->chain), 0.0);
    EXPECT_EQ(drive.allocations, 0) << kind->name;
    for (const int visits : drive.visits) EXPECT_GT(visits, 50) << kind->name;
  }
}

TEST_F(Allocation, NeverHappensInAKernelForThreeToTwelveJoints) {
  std::mt19937 generator(601);
  for (int n = 3; n <= kMaxJoints; ++n) {
    const RobotModel arm = test::random_arm(n, 700u + static_cast<unsigned>(n), true);
    const Chain& chain = arm.chain;
    const JointVector q = test::random_configuration(generator, arm);
    const JointVector qd = test::random_vector(generator, n, 1.0);
    const JointVector qdr = test::random_vector(generator, n, 1.0);
    const JointVector qdd = test::random_vector(generator, n, 2.0);
    const long before = test::allocations();
    Poses poses;
    Jacobian J;
    Jacobian J_dot;
    JointMatrix M;
    JointVector tau;
    SlotineLi motion;
    ParameterVector gradient;
    Regressor Y;
    forward_kinematics(chain, q, poses);
    tool_jacobian(chain, poses, J);
    tool_jacobian_derivative(chain, poses, J, qd, J_dot);
    mass_matrix(chain, poses, M);
    inverse_dynamics(chain, poses, qd, qdd, tau);
    gravity_torque(chain, poses, tau);
    slotine_li_forward(chain, poses, qd, qdr, qdd, motion);
    const ParameterVector theta = theta_of(chain);
    slotine_li_torque(chain, poses, motion, theta, tau);
    slotine_li_gradient(motion, gradient);
    slotine_li_regressor(chain, poses, motion, Y);
    ForwardDynamics work;
    JointVector qdd_of_torque;
    forward_dynamics(chain, poses, qd, tau, work, qdd_of_torque);
    EXPECT_EQ(test::allocations(), before) << arm.name;
    EXPECT_TRUE(tau.allFinite() && qdd_of_torque.allFinite() && gradient.allFinite() && Y.allFinite() &&
                J_dot.allFinite() && M.allFinite());
  }
}

}  // namespace allocation_test
}  // namespace armtune::internal
