#include "core/robot/inverse_dynamics_derivatives.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/common/dual.hpp"
#include "core/robot/chain_cast.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace inverse_dynamics_derivatives_test {

using test::WorstError;

constexpr int kSamples = 10;
using Along = Dual<3 * kMaxJoints>;

/// The recursion itself on dual numbers: another way to the same derivatives.
struct ByDuals {
  JointVector tau;
  JointMatrix by_q, by_qd, by_qdd;

  ByDuals(const Chain& chain, const JointVector& q, const JointVector& qd, const JointVector& qdd) {
    const int n = chain.n;
    JointVectorT<Along> q_ = q.cast<Along>();
    JointVectorT<Along> qd_ = qd.cast<Along>();
    JointVectorT<Along> qdd_ = qdd.cast<Along>();
    for (int i = 0; i < n; ++i) {
      q_[i].slope[i] = 1.0;
      qd_[i].slope[n + i] = 1.0;
      qdd_[i].slope[2 * n + i] = 1.0;
    }
    const ChainT<Along> dual = chain_cast<Along>(chain);
    PosesT<Along> poses;
    forward_kinematics(dual, q_, poses);
    JointVectorT<Along> torque;
    inverse_dynamics(dual, poses, qd_, qdd_, torque);
    tau.resize(n);
    by_q.resize(n, n);
    by_qd.resize(n, n);
    by_qdd.resize(n, n);
    for (int i = 0; i < n; ++i) {
      tau[i] = torque[i].value;
      for (int j = 0; j < n; ++j) {
        by_q(i, j) = torque[i].slope[j];
        by_qd(i, j) = torque[i].slope[n + j];
        by_qdd(i, j) = torque[i].slope[2 * n + j];
      }
    }
  }
};

TEST(InverseDynamicsDerivatives, AreThoseOfTheRecursionOnDualNumbers) {
  std::mt19937 generator(301);
  WorstError tau("torque", 1e-12);
  WorstError by_q("along q", 1e-12);
  WorstError by_qd("along q'", 1e-12);
  WorstError by_qdd("along q''", 1e-12);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 5.0);
      InverseDynamicsDerivatives analytic;
      inverse_dynamics_derivatives(arm.chain, test::poses_at(arm.chain, q), qd, qdd, analytic);
      const ByDuals dual(arm.chain, q, qd, qdd);
      tau.compare(analytic.tau, dual.tau, arm.name);
      by_q.compare(analytic.by_q, dual.by_q, arm.name);
      by_qd.compare(analytic.by_qd, dual.by_qd, arm.name);
      by_qdd.compare(analytic.by_qdd, dual.by_qdd, arm.name);
    }
  }
}

TEST(InverseDynamicsDerivatives, AreTheTorquesDifferences) {
  std::mt19937 generator(302);
  WorstError worst("difference", 1e-7);  // of tanh(q'/0.05) too, whose fifth derivative is large
  for (const RobotModel& arm : test::all_arms()) {
    const JointVector q = test::random_configuration(generator, arm);
    const JointVector qd = test::random_vector(generator, arm.n(), 2.0);
    const JointVector qdd = test::random_vector(generator, arm.n(), 5.0);
    InverseDynamicsDerivatives analytic;
    inverse_dynamics_derivatives(arm.chain, test::poses_at(arm.chain, q), qd, qdd, analytic);
    for (int j = 0; j < arm.n(); ++j) {
      const JointVector unit = JointVector::Unit(arm.n(), j);
      const auto torque = [&](double a, double b) {
        return test::inverse_dynamics_at(arm.chain, q + a * unit, qd + b * unit, qdd);
      };
      worst.compare(JointVector(analytic.by_q.col(j)),
                    test::derivative([&](double h) { return torque(h, 0.0); }), arm.name, 1.0);
      worst.compare(JointVector(analytic.by_qd.col(j)),
                    test::derivative([&](double h) { return torque(0.0, h); }, 2e-4), arm.name, 1.0);
    }
  }
}

TEST(Dual, CarriesTheDerivativesOfEveryOperation) {
  const auto f = [](auto x, auto y) {
    using std::cos;
    using std::exp;
    using std::sin;
    using std::sqrt;
    auto result = sin(x) * cos(y) + exp(x * y) / sqrt(x + y) - (-x) / y;
    result += x;
    result *= y;
    result -= y;
    result /= x;
    return result;
  };
  const double x = 0.7;
  const double y = 1.3;
  const Dual<2> dual = f(Dual<2>::variable(x, 0), Dual<2>::variable(y, 1));
  EXPECT_EQ(dual.value, f(x, y));
  EXPECT_NEAR(dual.slope[0], test::derivative([&](double h) { return f(x + h, y); }), 1e-11);
  EXPECT_NEAR(dual.slope[1], test::derivative([&](double h) { return f(x, y + h); }), 1e-11);
}

}  // namespace inverse_dynamics_derivatives_test
}  // namespace armtune::internal
