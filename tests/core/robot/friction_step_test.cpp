#include "core/robot/friction_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

#include "core/robot/forward_dynamics.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace friction_step_test {

using test::WorstError;

constexpr double kStep = 0.002;
constexpr int kSamples = 20;

/// Returns the evaluation within a step of kStep that began at the velocity start.
JointVector evaluate(const Chain& chain, const JointVector& q, const JointVector& start,
                     const JointVector& qd, const JointVector& torque) {
  ForwardDynamics work;
  JointVector k;
  forward_dynamics(chain, test::poses_at(chain, q), qd, torque, FrictionStep<double>(kStep, start), work, k);
  return k;
}

JointVector accelerations(const Chain& chain, const JointVector& q, const JointVector& qd,
                          const JointVector& torque) {
  ForwardDynamics work;
  JointVector qdd;
  forward_dynamics(chain, test::poses_at(chain, q), qd, torque, work, qdd);
  return qdd;
}

/// What friction adds to each joint of an arm, by elimination of a dense M + D from the last joint on.
struct Added {
  JointVector inertia, force;
};
Added added_by_friction(const Chain& chain, const JointMatrix& mass_with_rotors, const JointVector& start,
                        const JointVector& qd) {
  const FrictionStep<double> friction(kStep, start);
  Added all{JointVector::Zero(chain.n), JointVector::Zero(chain.n)};
  JointMatrix A = mass_with_rotors;
  for (int k = chain.n - 1; k >= 0; --k) {
    const AddedByFriction<double> added = friction.added(chain, k, qd[k], A(k, k));
    all.inertia[k] = added.inertia;
    all.force[k] = added.force;
    A(k, k) += added.inertia;
    const JointVector column = A.col(k).head(k);
    A.topLeftCorner(k, k) -= column * column.transpose() / A(k, k);
  }
  return all;
}

/// The secant bound of friction's slope, written out.
JointVector slopes(const Chain& chain, const JointVector& qd) {
  return chain.viscous_friction +
         chain.coulomb_friction.cwiseQuotient(qd.cwiseAbs().cwiseMax(kCoulombVelocity));
}

/// Arms with friction from none to a thousand times the usual, with and without rotors.
template <typename F>
void for_each_case(unsigned seed, const F& f) {
  std::mt19937 generator(seed);
  for (const RobotModel& arm : test::all_arms()) {
    for (const bool rotors : {true, false}) {
      for (const double factor : {0.0, 0.1, 1.0, 10.0, 1000.0}) {
        Chain chain = arm.chain;
        chain.viscous_friction = factor * test::random_vector(generator, arm.n(), 1.0).cwiseAbs();
        chain.coulomb_friction = factor * test::random_vector(generator, arm.n(), 1.0).cwiseAbs();
        if (!rotors) chain.rotor_inertia.setZero();
        for (int sample = 0; sample < kSamples; ++sample) {
          const JointVector q = test::random_configuration(generator, arm);
          const double speed = sample % 2 == 0 ? 0.1 : 2.0;
          const JointVector start = test::random_vector(generator, arm.n(), speed);
          const JointVector qd = test::random_vector(generator, arm.n(), speed);
          JointMatrix M = test::mass_matrix_at(chain, q);
          M.diagonal() += chain.rotor_inertia;
          f(chain, q, start, qd, M, arm.name + (rotors ? "" : " without rotors"));
        }
      }
    }
  }
}

TEST(FrictionStep, SolvesTheEquationOfMotionWithWhatItAdds) {
  WorstError worst("(M + D + A) k = torque - bias + a", 1e-9);  // as ForwardDynamics.SolvesTheMassMatrix...
  std::mt19937 generator(811);
  int stiff = 0;
  for_each_case(810, [&](const Chain& chain, const JointVector& q, const JointVector& start,
                         const JointVector& qd, const JointMatrix& M, const std::string& name) {
    const JointVector torque = test::random_vector(generator, chain.n, 50.0);
    const Added added = added_by_friction(chain, M, start, qd);
    stiff += (added.inertia.array() > 0.0).any() ? 1 : 0;
    JointMatrix N = M;
    N.diagonal() += added.inertia;
    const JointVector bias = test::inverse_dynamics_at(chain, q, qd, JointVector::Zero(chain.n));
    const JointVector k = evaluate(chain, q, start, qd, torque);
    worst.compare(N * k, torque - bias + added.force, name, bias.norm());
  });
  EXPECT_GT(stiff, 100);
}

TEST(FrictionStep, HasNoMoreThanTwiceTheInertiaToStopInAStepWhateverTheArm) {
  int stiff = 0;
  for_each_case(820, [&](const Chain& chain, const JointVector&, const JointVector& start,
                         const JointVector& qd, const JointMatrix& M, const std::string& name) {
    const Added added = added_by_friction(chain, M, start, qd);
    JointMatrix N = M;
    N.diagonal() += added.inertia;
    const JointMatrix C = (kStep * slopes(chain, qd)).asDiagonal();
    // |1 - z| <= 1 for z up to 2: the largest eigenvalue of (M + D + A)^-1 h C.
    const Eigen::GeneralizedSelfAdjointEigenSolver<JointMatrix> solver(C, N, Eigen::EigenvaluesOnly);
    EXPECT_LE(solver.eigenvalues().maxCoeff(), 2.0 + 1e-9) << name;
    stiff += solver.eigenvalues().maxCoeff() > 0.5 ? 1 : 0;
  });
  EXPECT_GT(stiff, 100);
}

TEST(FrictionStep, LeavesJointsWhoseFrictionIsNotStiffAsTheyAreToTheBit) {
  std::mt19937 generator(831);
  for (const RobotModel& arm : test::all_arms()) {
    for (const double factor : {0.0, 1e-3}) {
      Chain chain = arm.chain;
      chain.viscous_friction.setConstant(factor);
      chain.coulomb_friction.setConstant(factor);
      for (int sample = 0; sample < kSamples; ++sample) {
        const JointVector q = test::random_configuration(generator, arm);
        const JointVector start = test::random_vector(generator, arm.n(), 1.0);
        const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
        const JointVector torque = test::random_vector(generator, arm.n(), 50.0);
        EXPECT_EQ(evaluate(chain, q, start, qd, torque), accelerations(chain, q, qd, torque)) << arm.name;
      }
    }
  }
}

/// One joint that turns the inertia d, a share of which is its rotor's.
Chain one_joint(double viscous, double coulomb, double rotor) {
  Chain chain;
  chain.n = 1;
  chain.rotor_inertia = JointVector::Constant(1, rotor);
  chain.viscous_friction = JointVector::Constant(1, viscous);
  chain.coulomb_friction = JointVector::Constant(1, coulomb);
  return chain;
}

TEST(FrictionStep, AddsAnInertiaThatIsContinuousAndNeverLessThanWhatStopsAStiffJoint) {
  const JointVector rest = JointVector::Zero(1);
  const FrictionStep<double> friction(kStep, rest);
  constexpr double d = 0.3;
  for (const double rotor : {0.0, 0.02, 0.1, d}) {
    double before = 0.0;
    double z_before = 0.0;
    for (double z = 1e-3; z < 1e3; z *= 1.01) {  // h c / d
      const Chain chain = one_joint(z * d / kStep, 0.0, rotor);
      const double added = friction.added(chain, 0, 0.0, d).inertia;
      // Its slope is at most that of h c.
      EXPECT_GE(added, before);
      EXPECT_LE(added - before, (z - z_before) * d * (1.0 + 1e-9)) << z << " with rotor " << rotor;
      // Friction alone takes away at most the whole velocity, and all of it beyond 2.
      EXPECT_LE(z * d / (d + added), 1.0 + 1e-12) << z << " with rotor " << rotor;
      if (z >= 2.0) {
        EXPECT_NEAR(z * d / (d + added), 1.0, 1e-12) << z;
      }
      before = added;
      z_before = z;
    }
  }
}

TEST(FrictionStep, TakesViscousFrictionInTheMiddleOfTheStepWhateverTheVelocityOfTheEvaluation) {
  constexpr double d = 0.3;
  const JointVector start = JointVector::Constant(1, 0.7);
  const FrictionStep<double> friction(kStep, start);
  for (const double rotor : {0.0, 0.1, d}) {
    for (const double z : {1.0, 1.5, 1.99}) {  // h c / d
      const double c = z * d / kStep;
      const Chain chain = one_joint(c, 0.0, rotor);
      for (const double v : {-0.4, 0.0, 0.6, 0.7}) {
        const AddedByFriction<double> added = friction.added(chain, 0, v, d);
        // (d + h c / 2) k = -c v0, from d k = -c v and what is added to both sides.
        EXPECT_NEAR(added.inertia, 0.5 * kStep * c, 1e-12 * d) << z << " with rotor " << rotor;
        EXPECT_NEAR(-c * v + added.force, -c * start[0], 1e-12 * c) << z << ", " << v;
      }
    }
  }
}

TEST(FrictionStep, IsStableForTheSecantOfFastJointsNotForTheirSlope) {
  const JointVector rest = JointVector::Zero(1);
  const FrictionStep<double> friction(kStep, rest);
  constexpr double d = 1e-4;
  const Chain chain = one_joint(0.0, 1.0, 0.0);
  for (const double v : {1e-9, 0.01, 0.05, 0.2, 1.0, 5.0, 20.0}) {
    const double added = friction.added(chain, 0, v, d).inertia;
    // The velocity that Coulomb friction takes away in a step is at most what there is.
    EXPECT_LE(kStep * coulomb_direction(v) / (d + added), v * (1.0 + 1e-9)) << v;
    // No joint is slowed down by more than that: h Fc / |v| is what stops it in a step.
    EXPECT_NEAR(d + added, std::max(kStep / std::max(v, kCoulombVelocity), 1.5 * d), 1e-12) << v;
  }
}

}  // namespace friction_step_test
}  // namespace armtune::internal
