#include "core/control/velocity_governor.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace velocity_governor_test {

using test::derivative;
using test::random_vector;
using test::WorstError;

constexpr int kSamples = 200;

JointVector random_bound(std::mt19937& generator, int n) {
  return random_vector(generator, n, 1.0) + JointVector::Constant(n, 2.0);
}

/// The 16-norm of the joints' shares, as its definition has it.
double norm_of_shares(const JointVector& velocity, const JointVector& bound) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) sum += std::pow(velocity[i] / bound[i], 16.0);
  return std::pow(sum, 1.0 / 16.0);
}

/// References of 1 to 12 joints whose norm of shares is from 0.01 to 30.
template <typename Check>
void for_all_references(unsigned seed, const Check& check) {
  std::mt19937 generator(seed);
  for (int n = 1; n <= kMaxJoints; ++n) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector bound = random_bound(generator, n);
      JointReference reference{random_vector(generator, n, 1.0), random_vector(generator, n, 10.0)};
      const double r = std::pow(10.0, test::random_number(generator, -2.0, 1.5));
      reference.velocity *= r / norm_of_shares(reference.velocity, bound);
      check(bound, reference, r, fmt::format("{} joints, norm {:.3g}", n, r));
    }
  }
}

TEST(Governor, KeepsTheDirection) {
  for_all_references(721, [](const JointVector& bound, const JointReference& before, double /*r*/,
                             const std::string& where) {
    JointReference after = before;
    const double sigma = govern(bound, after);
    EXPECT_GT(sigma, 0.0) << where;
    EXPECT_LE(sigma, 1.0) << where;
    EXPECT_EQ(after.velocity, JointVector(sigma * before.velocity)) << where;
  });
}

TEST(Governor, KeepsEveryJointBelowItsBound) {
  for_all_references(
      722, [](const JointVector& bound, const JointReference& before, double r, const std::string& where) {
        JointReference after = before;
        govern(bound, after);
        // Far beyond the bound tanh is 1 to the last bit, and one joint alone is at its bound but for
        // rounding.
        const double limit = r < 3.0 ? 1.0 : 1.0 + 1e-15;
        EXPECT_LT(after.velocity.cwiseQuotient(bound).cwiseAbs().maxCoeff(), limit) << where;
      });
}

TEST(Governor, LeavesTheReferenceToTheBitUpToTheKneeAndSlowsItBeyond) {
  int left = 0;
  int slowed = 0;
  for_all_references(
      723, [&](const JointVector& bound, const JointReference& before, double r, const std::string& where) {
        JointReference after = before;
        const double sigma = govern(bound, after);
        if (r < kGovernorKnee * (1.0 - 1e-14)) {  // rounding of the norm
          ++left;
          EXPECT_EQ(sigma, 1.0) << where;
          EXPECT_EQ(after.velocity, before.velocity) << where;
          EXPECT_EQ(after.acceleration, before.acceleration) << where;
        } else if (r > kGovernorKnee + 1e-3) {
          ++slowed;
          EXPECT_LT(sigma, 1.0) << where;
        }
      });
  EXPECT_GT(left, 100);
  EXPECT_GT(slowed, 100);
}

TEST(Governor, LetsAFasterReferenceBeFaster) {
  const JointVector bound = JointVector::Constant(1, 1.3);
  double last = 0.0;
  for (int step = 1; step < 200; ++step) {
    const double r = 0.01 * step;
    JointReference reference{JointVector::Constant(1, r * 1.3), JointVector::Zero(1)};
    govern(bound, reference);
    EXPECT_GT(reference.velocity[0], last) << r;
    last = reference.velocity[0];
  }
}

/// f(r) of one joint: the share of its bound that is left of r.
double slowed_share(double r) {
  JointReference reference{JointVector::Constant(1, r * 1.3), JointVector::Zero(1)};
  govern(JointVector::Constant(1, 1.3), reference);
  return reference.velocity[0] / 1.3;
}

TEST(Governor, IsTwiceContinuouslyDifferentiableAtTheKnee) {
  // Beyond the knee f' - 1 vanishes as the square of the distance and f'' as the distance itself; before it
  // both are zero. tanh x = x - x^3/3 + ... with x = distance / 0.2 makes f'' = -2 distance / 0.2^2.
  for (const double distance : {1e-2, 3e-3, 1e-3}) {
    const double h = distance / 10.0;
    const double r = kGovernorKnee + distance;
    const double slope = (slowed_share(r + h) - slowed_share(r - h)) / (2.0 * h);
    const double bend = (slowed_share(r + h) - 2.0 * slowed_share(r) + slowed_share(r - h)) / (h * h);
    EXPECT_LT(std::abs(slope - 1.0), 30.0 * distance * distance) << distance;
    EXPECT_LT(std::abs(bend), 60.0 * distance) << distance;
    EXPECT_LT(bend, -40.0 * distance) << distance;
  }
}

TEST(Governor, AccelerationIsThatOfTheSlowedMotionWhoseTimeRunsAtItsPace) {
  std::mt19937 generator(724);
  // A difference with h = 2e-5: rounding, 1e-16 / h of velocities of 1, and h^4 / 30 of the fifth derivative
  // of a 16-norm, (16 q''/q')^5 or 1e11 on the slowest of the samples.
  WorstError worst("derivative of the slowed velocity", 1e-9);
  int slowed = 0;
  for (int n = 1; n <= kMaxJoints; ++n) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector bound = random_bound(generator, n);
      const JointVector velocity =
          test::random_number(generator, 0.3, 2.0) * random_vector(generator, n, 3.0);
      const JointVector acceleration = random_vector(generator, n, 2.0);
      // The motion v(tau) with tau' = sigma: d/dt = sigma d/dtau.
      const auto governed = [&](double tau) {
        JointReference reference{velocity + tau * acceleration, acceleration};
        govern(bound, reference);
        return JointVector(reference.velocity);
      };
      JointReference now{velocity, acceleration};
      const double sigma = govern(bound, now);
      slowed += sigma < 1.0 ? 1 : 0;
      worst.compare(now.acceleration, JointVector(sigma * derivative(governed, 2e-5)), fmt::format("{}", n),
                    1.0);
    }
  }
  EXPECT_GT(slowed, 500);
}

TEST(ShortestDuration, LetsTheQuinticsFastestJointJustReachItsBoundInSpeedOrInAcceleration) {
  std::mt19937 generator(725);
  WorstError worst("peak over bound", 1e-9);  // the inverse of a Jacobian of condition up to 1e3, squared
  int by_speed = 0;
  int by_acceleration = 0;
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.n() < 6) continue;
    for (int sample = 0; sample < 30; ++sample) {
      const Jacobian J = test::tool_jacobian_at(arm.chain, test::random_configuration(generator, arm));
      TaskInverse inverse;
      inverse.compute(J, {1e-3, 0.05});
      if (inverse.damped()) continue;
      const Vec6 displacement = random_vector(generator, 6, sample % 2 == 0 ? 1.0 : 1e-3);
      const JointVector bound = random_bound(generator, arm.n());
      const double T = shortest_duration(inverse, displacement, bound);
      const JointVector way =
          Eigen::MatrixXd(J).completeOrthogonalDecomposition().solve(Eigen::VectorXd(displacement));
      const Quintic<double> s = rest_to_rest(0.0, 1.0, T);
      // It is fastest half way and accelerates most at (3 - sqrt 3) / 6 of the time.
      const double share = way.cwiseQuotient(bound).cwiseAbs().maxCoeff();
      const double speed = s.at(0.5 * T).velocity * share;
      const double acceleration = s.at(T * (3.0 - std::sqrt(3.0)) / 6.0).acceleration * share * kRampTime;
      for (int step = 0; step <= 100; ++step) {
        EXPECT_LE(s.at(T * step / 100.0).velocity * share, speed * (1.0 + 1e-12));
        EXPECT_LE(std::abs(s.at(T * step / 100.0).acceleration) * share * kRampTime,
                  acceleration * (1.0 + 1e-12));
      }
      worst.compare(std::max(speed, acceleration), 1.0, arm.name);
      ++(speed > acceleration ? by_speed : by_acceleration);
    }
  }
  EXPECT_GT(by_speed, 20);
  EXPECT_GT(by_acceleration, 20);
}

}  // namespace velocity_governor_test
}  // namespace armtune::internal
