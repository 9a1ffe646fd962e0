#include "core/robot/slotine_li.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace slotine_li_test {

using test::derivative;
using test::WorstError;

constexpr int kSamples = 10;
constexpr double kRounding = 1e-12;  // exact algorithms of the same quantity differ by rounding only

struct State {
  JointVector q, qd, qdr, qddr;
};

State random_state(std::mt19937& generator, const RobotModel& arm) {
  return {test::random_configuration(generator, arm), test::random_vector(generator, arm.n(), 1.5),
          test::random_vector(generator, arm.n(), 1.5), test::random_vector(generator, arm.n(), 4.0)};
}

SlotineLi forward(const Chain& chain, const State& x) {
  SlotineLi motion;
  slotine_li_forward(chain, test::poses_at(chain, x.q), x.qd, x.qdr, x.qddr, motion);
  return motion;
}

/// Y theta by recursion.
JointVector torque(const Chain& chain, const State& x, const ParameterVector& theta) {
  JointVector tau;
  slotine_li_torque(chain, test::poses_at(chain, x.q), forward(chain, x), theta, tau);
  return tau;
}
JointVector torque(const Chain& chain, const State& x) {
  return torque(chain, x, theta_of(chain));
}

Regressor regressor(const Chain& chain, const State& x) {
  Regressor Y;
  slotine_li_regressor(chain, test::poses_at(chain, x.q), forward(chain, x), Y);
  return Y;
}

/// C(q, q'), column by column: what a unit reference velocity of one joint adds to gravity and friction.
JointMatrix coriolis_matrix(const Chain& chain, const JointVector& q, const JointVector& qd) {
  const int n = chain.n;
  const JointVector zero = JointVector::Zero(n);
  const JointVector rest = test::gravity_torque_at(chain, q) + test::friction_at(chain, qd);
  JointMatrix C(n, n);
  for (int j = 0; j < n; ++j) C.col(j) = torque(chain, {q, qd, JointVector::Unit(n, j), zero}) - rest;
  return C;
}

/// C(q, q') q' from the Christoffel symbols of a mass matrix differenced by q.
JointVector christoffel_torque(const Chain& chain, const JointVector& q, const JointVector& qd) {
  const int n = chain.n;
  JointVector c = JointVector::Zero(n);
  for (int i = 0; i < n; ++i) {
    const JointMatrix dM = derivative([&](double t) {
      JointVector moved = q;
      moved[i] += t;
      return test::mass_matrix_at(chain, moved);
    });
    c += qd[i] * (dM * qd);
    c[i] -= 0.5 * qd.dot(dM * qd);
  }
  return c;
}

TEST(SlotineLiTorque, IsInverseDynamicsWhenTheReferencesAreTheMotion) {
  std::mt19937 generator(301);
  WorstError worst("Y theta", 1e-10);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      State x = random_state(generator, arm);
      x.qdr = x.qd;
      worst.compare(torque(arm.chain, x), test::inverse_dynamics_at(arm.chain, x.q, x.qd, x.qddr), arm.name);
    }
  }
}

TEST(SlotineLiTorque, IsTheRegressorTimesThetaForParametersOfAnyKind) {
  std::mt19937 generator(302);
  WorstError worst("Y theta", kRounding);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      ParameterVector theta(parameter_count(arm.chain));  // negative masses and inertias too
      for (double& value : theta) value = test::random_number(generator, -3.0, 3.0);
      worst.compare(torque(arm.chain, x, theta), JointVector(regressor(arm.chain, x) * theta), arm.name);
    }
  }
}

TEST(SlotineLiGradient, IsTheTransposedRegressorTimesS) {
  std::mt19937 generator(303);
  WorstError worst("Y^T S", kRounding);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      ParameterVector gradient;
      slotine_li_gradient(forward(arm.chain, x), gradient);
      worst.compare(gradient, ParameterVector(regressor(arm.chain, x).transpose() * (x.qd - x.qdr)),
                    arm.name);
    }
  }
}

TEST(SlotineLiGradient, TakesTheRegressorOfOneMotionAndTheSOfAnother) {
  std::mt19937 generator(305);
  WorstError worst("Y^T S", kRounding);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      State along = random_state(generator, arm);
      along.q = x.q;
      ParameterVector gradient;
      slotine_li_gradient(forward(arm.chain, along), forward(arm.chain, x), gradient);
      worst.compare(gradient, ParameterVector(regressor(arm.chain, along).transpose() * (x.qd - x.qdr)),
                    arm.name);
    }
  }
}

TEST(SlotineLiTorque, IsMassRotorCoriolisGravityAndFrictionOfIndependentReferences) {
  std::mt19937 generator(304);
  WorstError worst("sum", 1e-11);  // C is a difference of torques: a digit less
  for (const RobotModel& arm : test::all_arms()) {
    const Chain& chain = arm.chain;
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      const JointVector sum = test::mass_matrix_at(chain, x.q) * x.qddr +
                              chain.rotor_inertia.cwiseProduct(x.qddr) +
                              coriolis_matrix(chain, x.q, x.qd) * x.qdr +
                              test::gravity_torque_at(chain, x.q) + test::friction_at(chain, x.qd);
      worst.compare(torque(chain, x), sum, arm.name);
    }
  }
}

TEST(SlotineLiTorque, IsLinearInTheReferenceVelocity) {
  std::mt19937 generator(305);
  WorstError worst("linear", 1e-11);  // differences of torques
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      const State y = random_state(generator, arm);
      const auto at = [&](const JointVector& qdr) { return torque(arm.chain, {x.q, x.qd, qdr, x.qddr}); };
      const JointVector none = at(JointVector::Zero(arm.n()));
      worst.compare(JointVector(at(2.0 * x.qdr - 3.0 * y.qdr) - none),
                    JointVector(2.0 * (at(x.qdr) - none) - 3.0 * (at(y.qdr) - none)), arm.name, none.norm());
    }
  }
}

TEST(SlotineLiTorque, HasACoriolisMatrixThatMakesTheRateOfMassMinusTwiceItSkew) {
  std::mt19937 generator(306);
  // M' is a difference of M, which moves at twice the rate of a pose: at 10 rad/s, 10^5 h^4 / 30 = 3e-9.
  WorstError worst("M' - 2C", 3e-9);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      const JointMatrix M_dot =
          derivative([&](double t) { return test::mass_matrix_at(arm.chain, x.q + t * x.qd); });
      const JointMatrix N = M_dot - 2.0 * coriolis_matrix(arm.chain, x.q, x.qd);
      worst.compare(N, JointMatrix(-N.transpose()), arm.name);
    }
  }
}

TEST(SlotineLiTorque, HasTheCoriolisTorqueOfTheChristoffelSymbols) {
  std::mt19937 generator(307);
  WorstError worst("C q'", 1e-9);  // one joint moves at a time: M is of second order in its sinusoid
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const State x = random_state(generator, arm);
      worst.compare(JointVector(coriolis_matrix(arm.chain, x.q, x.qd) * x.qd),
                    christoffel_torque(arm.chain, x.q, x.qd), arm.name);
    }
  }
}

TEST(SlotineLiTorque, TakesFrictionFromTheMeasuredVelocityNotTheReference) {
  std::mt19937 generator(308);
  WorstError worst("friction", 1e-11);
  for (const RobotModel& arm : test::all_arms()) {
    const State x = random_state(generator, arm);
    ParameterVector theta = ParameterVector::Zero(parameter_count(arm.chain));
    for (int i = 0; i < arm.n(); ++i) {
      theta.segment<kJointParameters>(joint_parameter_index(arm.n(), i)) << 0.0, 1.0 + i, 2.0 + i;
    }
    JointVector expected(arm.n());
    for (int i = 0; i < arm.n(); ++i)
      expected[i] = (1.0 + i) * x.qd[i] + (2.0 + i) * std::tanh(x.qd[i] / 0.05);
    worst.compare(torque(arm.chain, x, theta), expected, arm.name);
  }
}

}  // namespace slotine_li_test
}  // namespace armtune::internal
