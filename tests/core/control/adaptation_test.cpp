#include "core/control/adaptation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune {
namespace {

using test::random_vector;
using test::WorstError;

constexpr double kGamma = 0.05;
constexpr double kPeriod = 0.002;

struct Motion {
  Poses poses;
  SlotineLi y;
  JointVector S;
};

Motion random_motion(std::mt19937& generator, const RobotModel& arm) {
  Motion m;
  m.poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
  const JointVector qd = random_vector(generator, arm.n(), 1.0);
  const JointVector qdr = random_vector(generator, arm.n(), 1.0);
  slotine_li_forward(arm.chain, m.poses, qd, qdr, random_vector(generator, arm.n(), 2.0), m.y);
  m.S = qd - qdr;
  return m;
}

TEST(Adaptation, StepsAgainstTheTransposedRegressorTimesS) {
  std::mt19937 generator(541);
  WorstError worst("step", 1e-12);  // rounding
  for (const RobotModel& arm : test::all_arms()) {
    const Motion m = random_motion(generator, arm);
    Regressor Y;
    slotine_li_regressor(arm.chain, m.poses, m.y, Y);
    const ParameterVector theta = theta_of(arm.chain);
    Adaptation adaptation(theta);
    EXPECT_EQ(adaptation.theta(), theta);
    adaptation.step(m.y, kGamma, kPeriod);
    worst.compare(ParameterVector(adaptation.theta() - theta),
                  ParameterVector(-kGamma * kPeriod * (Y.transpose() * m.S)), arm.name, 1e-3);
  }
}

TEST(Adaptation, LowersThePowerThatTheParameterErrorPutsIntoS) {
  std::mt19937 generator(542);
  for (const RobotModel& arm : test::all_arms()) {
    const Motion m = random_motion(generator, arm);
    const ParameterVector truth = theta_of(arm.chain);
    Adaptation adaptation(ParameterVector::Zero(truth.size()));
    // S^T Y (theta - truth), the part of Lyapunov's V' that adaptation is there to cancel.
    const auto power = [&] {
      JointVector tau;
      slotine_li_torque(arm.chain, m.poses, m.y, ParameterVector(adaptation.theta() - truth), tau);
      return m.S.dot(tau);
    };
    double last = power();
    for (int step = 0; step < 10; ++step) {
      adaptation.step(m.y, kGamma, kPeriod);
      EXPECT_LT(power(), last) << arm.name;
      last = power();
    }
  }
}

TEST(Adaptation, StandsStillWhereSIsZeroOrGammaIs) {
  std::mt19937 generator(543);
  for (const RobotModel& arm : test::all_arms()) {
    const ParameterVector theta = theta_of(arm.chain);
    Adaptation adaptation(theta);
    Motion m = random_motion(generator, arm);
    adaptation.step(m.y, 0.0, kPeriod);
    EXPECT_EQ(adaptation.theta(), theta) << arm.name;
    const JointVector qd = random_vector(generator, arm.n(), 1.0);
    slotine_li_forward(arm.chain, m.poses, qd, qd, qd, m.y);
    adaptation.step(m.y, kGamma, kPeriod);
    EXPECT_EQ(adaptation.theta(), theta) << arm.name;
  }
}

}  // namespace
}  // namespace armtune
