#include "core/robot/forward_dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace forward_dynamics_test {

using test::WorstError;

constexpr int kSamples = 20;

JointVector forward_dynamics_at(const Chain& chain, const JointVector& q, const JointVector& qd,
                                const JointVector& torque) {
  Poses poses;
  body_poses(chain, q, poses);
  ForwardDynamics work;
  JointVector qdd;
  forward_dynamics(chain, poses, qd, torque, work, qdd);
  return qdd;
}

TEST(ForwardDynamics, UndoesInverseDynamics) {
  std::mt19937 generator(801);
  WorstError worst("q''", 1e-9);  // rounding, times the condition number of M + D, up to 1e5 on random arms
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 5.0);
      const JointVector torque = test::inverse_dynamics_at(arm.chain, q, qd, qdd);
      worst.compare(forward_dynamics_at(arm.chain, q, qd, torque), qdd, arm.name);
    }
  }
}

// Without rotor inertia nothing but the links' own inertia is left to divide by.
TEST(ForwardDynamics, SolvesTheMassMatrixWithAndWithoutRotors) {
  std::mt19937 generator(802);
  WorstError worst("(M + D) q'' = torque - bias", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    for (const bool rotors : {true, false}) {
      Chain chain = arm.chain;
      if (!rotors) chain.rotor_inertia.setZero();
      for (int sample = 0; sample < kSamples; ++sample) {
        const JointVector q = test::random_configuration(generator, arm);
        const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
        const JointVector torque = test::random_vector(generator, arm.n(), 50.0);
        JointMatrix M = test::mass_matrix_at(chain, q);
        M.diagonal() += chain.rotor_inertia;
        const JointVector bias = test::inverse_dynamics_at(chain, q, qd, JointVector::Zero(arm.n()));
        worst.compare(M * forward_dynamics_at(chain, q, qd, torque), torque - bias,
                      arm.name + (rotors ? "" : " without rotors"));
      }
    }
  }
}

TEST(ForwardDynamics, NeedsNothingButBodyPosesAndKeepsNothing) {
  const RobotModel arm = test::ur10();
  std::mt19937 generator(803);
  const JointVector q = test::random_configuration(generator, arm);
  const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
  const JointVector torque = test::random_vector(generator, arm.n(), 50.0);
  const JointVector fresh = forward_dynamics_at(arm.chain, q, qd, torque);
  ForwardDynamics used;
  JointVector qdd;
  forward_dynamics(arm.chain, test::poses_at(arm.chain, -q), JointVector(-3.0 * qd), torque, used, qdd);
  forward_dynamics(arm.chain, test::poses_at(arm.chain, q), qd, torque, used, qdd);
  EXPECT_EQ(qdd, fresh);
}

}  // namespace forward_dynamics_test
}  // namespace armtune::internal
