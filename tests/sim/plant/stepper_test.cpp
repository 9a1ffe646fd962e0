#include "sim/plant/stepper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armtune/error.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace stepper_test {

/// Error at t = 1 s of the damped oscillator q'' = -w^2 q - 2 d q', which starts at q = 1, q' = 0.
double error_with_step(Stepper stepper, int steps) {
  constexpr double w = 3.0;
  constexpr double d = 0.4;
  JointVector q = JointVector::Ones(1);
  JointVector qd = JointVector::Zero(1);
  StepWorkspace work;
  for (int k = 0; k < steps; ++k) {
    integrate(
        stepper, 1.0 / steps,
        [](const JointVector& x, const JointVector& v, JointVector& a) { a = -w * w * x - 2.0 * d * v; }, q,
        qd, work);
  }
  const double wd = std::sqrt(w * w - d * d);
  const double exact = std::exp(-d) * (std::cos(wd) + d / wd * std::sin(wd));
  const double exact_velocity = -std::exp(-d) * w * w / wd * std::sin(wd);
  return std::hypot(q[0] - exact, qd[0] - exact_velocity);
}

double order(Stepper stepper, int steps) {
  return std::log2(error_with_step(stepper, steps) / error_with_step(stepper, 2 * steps));
}

TEST(Stepper, ConvergesWithItsOrder) {
  EXPECT_NEAR(order(Stepper::kSemiImplicitEuler, 2000), 1.0, 0.05);
  EXPECT_NEAR(order(Stepper::kMidpoint, 500), 2.0, 0.05);
  EXPECT_NEAR(order(Stepper::kRungeKutta4, 100), 4.0, 0.1);
}

TEST(Stepper, NamesReadBack) {
  for (const Stepper stepper :
       {Stepper::kMidpoint, Stepper::kSemiImplicitEuler, Stepper::kRungeKutta4, Stepper::kReference}) {
    EXPECT_EQ(stepper_from_name(name(stepper)), stepper);
  }
}

TEST(Stepper, AnUnknownNameIsRefusedWithThoseThereAre) {
  EXPECT_THAT(
      [] { stepper_from_name("rk5"); },
      test::refused_at(
          {.key = "stepper", .value = "rk5", .limit = "midpoint, semi_implicit_euler, rk4 or reference"}));
}

}  // namespace stepper_test
}  // namespace armtune::internal
