#include "core/robot/dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace dynamics_test {

using test::derivative;
using test::WorstError;

constexpr int kSamples = 10;

/// Kinetic energy of all bodies at (q, q'), without rotors. Body twists are finite differences of poses, so
/// that nothing but forward kinematics is shared with the recursions under test.
double kinetic_energy(const Chain& chain, const JointVector& q, const JointVector& qd) {
  const double h = 1e-3;
  std::array<Poses, 4> moved;
  const std::array<double, 4> steps = {-2.0 * h, -h, h, 2.0 * h};
  for (std::size_t s = 0; s < steps.size(); ++s) moved[s] = test::poses_at(chain, q + steps[s] * qd);
  const auto rate = [h](const auto& far_back, const auto& back, const auto& ahead, const auto& far_ahead) {
    return ((far_back - far_ahead + 8.0 * (ahead - back)) / (12.0 * h)).eval();
  };
  const Poses poses = test::poses_at(chain, q);
  double energy = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(chain.n); ++k) {
    const Vec3 v = rate(moved[0].p_0B[k], moved[1].p_0B[k], moved[2].p_0B[k], moved[3].p_0B[k]);
    const Mat3 R_dot = rate(moved[0].R_0B[k], moved[1].R_0B[k], moved[2].R_0B[k], moved[3].R_0B[k]);
    const Mat3 W = poses.R_0B[k].transpose() * R_dot;  // body frame
    const Vec3 w = 0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
    const LinkInertia& body = chain.link[k];
    energy += 0.5 * body.mass * v.squaredNorm() + v.dot(poses.R_0B[k] * w.cross(body.first_moment)) +
              0.5 * w.dot(body.inertia * w);
  }
  return energy;
}

double potential_energy(const Chain& chain, const JointVector& q) {
  const Poses poses = test::poses_at(chain, q);
  double energy = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(chain.n); ++k) {
    energy -=
        chain.gravity.dot(chain.link[k].mass * poses.p_0B[k] + poses.R_0B[k] * chain.link[k].first_moment);
  }
  return energy;
}

/// M(q) = sum of J_v^T m J_v + J_w^T I J_w over the bodies, with point Jacobians at their centres of mass.
JointMatrix mass_from_body_jacobians(const Chain& chain, const JointVector& q) {
  const Poses poses = test::poses_at(chain, q);
  JointMatrix M = JointMatrix::Zero(chain.n, chain.n);
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LinkInertia& body = chain.link[k];
    // Centre of mass and inertia about it, in the base's axes: J_v^T m J_v + J_w^T I_C J_w.
    const Vec3 c = body.first_moment / body.mass;
    const Mat3 I_C = body.inertia - body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
    Jacobian J;
    point_jacobian(chain, poses, i, Vec3(poses.p_0B[k] + poses.R_0B[k] * c), J);
    const Mat3 I_0 = poses.R_0B[k] * I_C * poses.R_0B[k].transpose();
    M += body.mass * J.topRows<3>().transpose() * J.topRows<3>() +
         J.bottomRows<3>().transpose() * I_0 * J.bottomRows<3>();
  }
  return M;
}

TEST(MassMatrix, IsSymmetricAndPositiveDefinite) {
  std::mt19937 generator(201);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointMatrix M = test::mass_matrix_at(arm.chain, test::random_configuration(generator, arm));
      EXPECT_EQ(M, M.transpose()) << arm.name;
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M).eigenvalues()[0], 0.0) << arm.name;
    }
  }
}

TEST(MassMatrix, IsTheSumOverTheBodiesJacobians) {
  std::mt19937 generator(202);
  WorstError worst("M", 1e-12);  // two exact algorithms: rounding
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      worst.compare(test::mass_matrix_at(arm.chain, q), mass_from_body_jacobians(arm.chain, q), arm.name);
    }
  }
}

TEST(MassMatrix, GivesTheKineticEnergyOfTheMovingBodies) {
  std::mt19937 generator(203);
  WorstError worst("kinetic energy",
                   1e-9);  // twists are differences of poses; at 5 rad/s, 5^5 h^4 / 30 = 1e-10
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      worst.compare(0.5 * qd.dot(test::mass_matrix_at(arm.chain, q) * qd), kinetic_energy(arm.chain, q, qd),
                    arm.name);
    }
  }
}

TEST(InverseDynamics, IsMassAndRotorTimesAccelerationPlusBiasPlusFriction) {
  std::mt19937 generator(204);
  WorstError worst("decomposition", 1e-12);  // rounding
  for (const RobotModel& arm : test::all_arms()) {
    const Chain smooth = test::without_friction(arm.chain);
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 5.0);
      const JointVector h = test::inverse_dynamics_at(smooth, q, qd, JointVector::Zero(arm.n()));
      const JointVector sum = test::mass_matrix_at(arm.chain, q) * qdd +
                              arm.chain.rotor_inertia.cwiseProduct(qdd) + h +
                              test::friction_at(arm.chain, qd);
      worst.compare(test::inverse_dynamics_at(arm.chain, q, qd, qdd), sum, arm.name);
    }
  }
}

TEST(InverseDynamics, SolvesLagrangesEquation) {
  std::mt19937 generator(205);
  // Differences of M, which moves at twice the rate of a pose: at 10 rad/s, 10^5 h^4 / 30 = 3e-9.
  WorstError worst("Lagrange", 3e-9);
  for (const RobotModel& arm : test::all_arms()) {
    const Chain& chain = arm.chain;
    for (int sample = 0; sample < 3; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 2.0);
      JointVector tau = derivative([&](double t) {
        return JointVector(mass_from_body_jacobians(chain, q + t * qd + (0.5 * t * t) * qdd) *
                           (qd + t * qdd));
      });
      for (int i = 0; i < arm.n(); ++i) {
        tau[i] -= derivative([&](double t) {
          JointVector moved = q;
          moved[i] += t;
          return 0.5 * qd.dot(mass_from_body_jacobians(chain, moved) * qd) - potential_energy(chain, moved);
        });
      }
      tau += chain.rotor_inertia.cwiseProduct(qdd) + test::friction_at(chain, qd);
      worst.compare(test::inverse_dynamics_at(chain, q, qd, qdd), tau, arm.name);
    }
  }
}

TEST(InverseDynamics, FrictionOpposesTheMotion) {
  std::mt19937 generator(206);
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.chain.viscous_friction.isZero()) continue;
    const JointVector q = test::random_configuration(generator, arm);
    const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
    const JointVector qdd = JointVector::Zero(arm.n());
    const JointVector overcome = test::inverse_dynamics_at(arm.chain, q, qd, qdd) -
                                 test::inverse_dynamics_at(test::without_friction(arm.chain), q, qd, qdd);
    EXPECT_TRUE((overcome.array() * qd.array() > 0.0).all()) << arm.name;
  }
}

TEST(GravityTorque, IsTheGradientOfThePotentialEnergy) {
  std::mt19937 generator(207);
  WorstError worst("gravity", 1e-9);  // one sinusoid per joint: rounding of the difference, 1e-16 / h
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      JointVector gradient(arm.n());
      for (int i = 0; i < arm.n(); ++i) {
        gradient[i] = derivative([&](double t) {
          JointVector moved = q;
          moved[i] += t;
          return potential_energy(arm.chain, moved);
        });
      }
      worst.compare(test::gravity_torque_at(arm.chain, q), gradient, arm.name);
    }
  }
}

TEST(InverseDynamics, PowerOfAFrictionlessArmIsTheRateOfItsEnergy) {
  std::mt19937 generator(208);
  // Differences of an energy whose twists are differences already; the floor is the size of one term, for the
  // power passes through zero.
  WorstError worst("power", 1e-8);
  for (const RobotModel& arm : test::all_arms()) {
    const Chain chain = test::without_friction(arm.chain);
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 2.0);
      const auto energy = [&](double t) {
        const JointVector q_t = q + t * qd + (0.5 * t * t) * qdd;
        const JointVector qd_t = qd + t * qdd;
        return kinetic_energy(chain, q_t, qd_t) + potential_energy(chain, q_t) +
               0.5 * qd_t.dot(chain.rotor_inertia.cwiseProduct(qd_t));
      };
      const JointVector tau = test::inverse_dynamics_at(chain, q, qd, qdd);
      worst.compare(derivative(energy), qd.dot(tau), arm.name, qd.norm() * tau.norm());
    }
  }
}

}  // namespace dynamics_test
}  // namespace armtune::internal
