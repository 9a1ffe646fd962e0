#include "core/control/adaptation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/control/adaptation_filter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace adaptation_test {

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
    adaptation.step(m.y, m.y, kGamma, kPeriod);
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
      adaptation.step(m.y, m.y, kGamma, kPeriod);
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
    adaptation.step(m.y, m.y, 0.0, kPeriod);
    EXPECT_EQ(adaptation.theta(), theta) << arm.name;
    const JointVector qd = random_vector(generator, arm.n(), 1.0);
    slotine_li_forward(arm.chain, m.poses, qd, qd, qd, m.y);
    adaptation.step(m.y, m.y, kGamma, kPeriod);
    EXPECT_EQ(adaptation.theta(), theta) << arm.name;
  }
}

TEST(Adaptation, InertiasLeakFasterByTheirOwnRate) {
  constexpr double kLeakage = 0.3;
  constexpr double kOfInertias = 0.5;
  const RobotModel arm = test::ur10();
  const int n = arm.n();
  const ParameterVector start = theta_of(arm.chain);
  Adaptation adaptation(start);
  adaptation.theta().array() += 1.0;
  adaptation.leak(kLeakage, kOfInertias, kPeriod);
  const ParameterVector away = adaptation.theta() - start;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 10; ++k) {  // m, m c, I
      const double rate = k < 4 ? kLeakage : kLeakage + kOfInertias;
      EXPECT_NEAR(away[10 * i + k], 1.0 - rate * kPeriod, 1e-12) << i << ' ' << k;
    }
    for (int k = 0; k < 3; ++k) {  // rotor inertia, friction
      const double rate = k == 0 ? kLeakage + kOfInertias : kLeakage;
      EXPECT_NEAR(away[10 * n + 3 * i + k], 1.0 - rate * kPeriod, 1e-12) << i << ' ' << k;
    }
  }
}

TEST(Adaptation, LeaksTowardsWhereItStartedAndNowhereElse) {
  std::mt19937 generator(544);
  const RobotModel arm = test::ur10();
  const ParameterVector start = theta_of(arm.chain);
  Adaptation adaptation(start);
  adaptation.leak(0.3, 0.0, kPeriod);
  EXPECT_EQ(adaptation.theta(), start) << "the start itself";
  for (int step = 0; step < 20; ++step) {
    const Motion m = random_motion(generator, arm);
    adaptation.step(m.y, m.y, 1.0, kPeriod);
  }
  const ParameterVector away = adaptation.theta() - start;
  ASSERT_GT(away.norm(), 0.1);
  // e^(-rate t); an Euler step of rate dt = 6e-4 is off by half of that per unit of rate t.
  WorstError worst("decay", 1e-3);
  for (int step = 1; step <= 1000; ++step) {
    adaptation.leak(0.3, 0.0, kPeriod);
    worst.compare(ParameterVector(adaptation.theta() - start),
                  ParameterVector(std::exp(-0.3 * step * kPeriod) * away), std::to_string(step));
  }
}

TEST(Adaptation, ProjectsThetaToThePhysicalOne) {
  std::mt19937 generator(545);
  for (const RobotModel& arm : test::all_arms()) {
    Adaptation adaptation(ParameterVector::Zero(parameter_count(arm.chain)));
    const Motion m = random_motion(generator, arm);
    adaptation.step(m.y, m.y, kGamma, kPeriod);
    ParameterVector expected = adaptation.theta();
    project_to_physical(expected);
    EXPECT_NE(adaptation.theta(), expected) << arm.name << ": one step from nothing is not physical";
    adaptation.project();
    EXPECT_EQ(adaptation.theta(), expected) << arm.name;
  }
}

/// Viscous friction as the adaptation sees it while the arm stands, and its velocity measures as white noise.
struct Standing {
  static constexpr double kSeconds = 60.0;
  static constexpr double kNoise = 0.05;  // [rad/s]

  /// theta - start of every joint's viscous friction, and of all of theta, after half of the time and the
  /// whole.
  JointVector half, whole;
  double largest_half = 0.0;
  double largest_whole = 0.0;

  Standing(const RobotModel& arm, double leakage, double corner = 0.0) {
    std::mt19937 generator(546);
    std::normal_distribution<double> noise(0.0, kNoise);
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const ParameterVector start = theta_of(arm.chain);
    const JointVector zero = JointVector::Zero(arm.n());
    Adaptation adaptation(start);
    JointVector qd(arm.n());
    SlotineLi y;
    SlotineLi smoothed;
    AdaptationFilter filter;
    filter.start(arm.n());
    const int periods = static_cast<int>(std::lround(kSeconds / kPeriod));
    for (int k = 1; k <= periods; ++k) {
      for (double& v : qd) v = noise(generator);
      slotine_li_forward(arm.chain, poses, qd, zero, zero, y);
      if (corner > 0.0) {
        filter.take(filter_share(corner, kPeriod), qd, zero, zero);
        filter.motion(arm.chain, poses, smoothed);
      }
      adaptation.step(corner > 0.0 ? smoothed : y, y, kGamma, kPeriod);
      adaptation.leak(leakage, 0.0, kPeriod);
      if (k == periods / 2 || k == periods) {
        const ParameterVector away = adaptation.theta() - start;
        JointVector& friction = k == periods ? whole : half;
        friction.resize(arm.n());
        for (int i = 0; i < arm.n(); ++i) friction[i] = away[joint_parameter_index(arm.n(), i) + 1];
      }
      double& largest = k <= periods / 2 ? largest_half : largest_whole;
      largest = std::max(largest, (adaptation.theta() - start).lpNorm<Eigen::Infinity>());
    }
  }
};

// Of viscous friction Y is q' and S is q' too, so noise of variance s^2 has (Y^T S) = s^2 on average: theta
// falls by gamma s^2 per second although nothing moves. Its spread over N periods is sqrt(2 / N), 0.8 % of
// 30000.
TEST(Adaptation, NoiseOfAStandingArmDrivesThetaAwayWithoutEnd) {
  const RobotModel arm = test::ur10();
  const Standing drift(arm, 0.0);
  const double fallen = -kGamma * Standing::kNoise * Standing::kNoise * Standing::kSeconds;
  WorstError worst("drift", 0.05);  // four spreads of half of the time
  for (int i = 0; i < arm.n(); ++i) {
    worst.compare(drift.whole[i], fallen, "60 s");
    worst.compare(drift.half[i], 0.5 * fallen, "30 s");
  }
  EXPECT_GT(drift.largest_whole, 1.8 * drift.largest_half);
}

TEST(Adaptation, LeakageBoundsWhatNoiseDoes) {
  const RobotModel arm = test::ur10();
  constexpr double kLeakage = 0.5;
  const Standing leaking(arm, kLeakage);
  // It comes to rest where the leak takes what the noise brings, and has done so after 30 s: e^-15.
  const double rest = -kGamma * Standing::kNoise * Standing::kNoise / kLeakage;
  WorstError worst("rest", 0.15);  // five spreads, sqrt(leakage dt) = 3 % each
  for (int i = 0; i < arm.n(); ++i) {
    worst.compare(leaking.half[i], rest, "30 s");
    worst.compare(leaking.whole[i], rest, "60 s");
  }
  EXPECT_LT(leaking.largest_whole, 1.2 * leaking.largest_half);
  EXPECT_LT(leaking.largest_whole, 0.1 * Standing(arm, 0.0).largest_whole);
}

TEST(Adaptation, StepsAgainstTheRegressorOfOneMotionTimesTheSOfAnother) {
  std::mt19937 generator(547);
  WorstError worst("step", 1e-12);  // rounding
  for (const RobotModel& arm : test::all_arms()) {
    const Motion m = random_motion(generator, arm);
    SlotineLi desired;
    const JointVector qd = random_vector(generator, arm.n(), 1.0);
    slotine_li_forward(arm.chain, m.poses, qd, qd, random_vector(generator, arm.n(), 2.0), desired);
    Regressor Y;
    slotine_li_regressor(arm.chain, m.poses, desired, Y);
    const ParameterVector theta = theta_of(arm.chain);
    Adaptation adaptation(theta);
    adaptation.step(desired, m.y, kGamma, kPeriod);
    worst.compare(ParameterVector(adaptation.theta() - theta),
                  ParameterVector(-kGamma * kPeriod * (Y.transpose() * m.S)), arm.name, 1e-3);
  }
}

// The filtered q' has the share a = 1 - exp(-2 pi f T) of this period's noise, and S all of it: the mean of
// their product, and with it the drift, is a times that of the unfiltered motion. The rest of the filtered
// noise is independent of S and adds a spread: sqrt(a / 2) s^2 per period, over 30000 periods 2 % of the
// drift here.
TEST(Adaptation, AFilteredMotionLearnsItsShareOfTheNoiseAlone) {
  const RobotModel arm = test::ur10();
  constexpr double kCorner = 5.0;  // Hz
  const Standing filtered(arm, 0.0, kCorner);
  const double unfiltered = -kGamma * Standing::kNoise * Standing::kNoise * Standing::kSeconds;
  const double share = filter_share(kCorner, kPeriod);
  for (int i = 0; i < arm.n(); ++i) {
    EXPECT_NEAR(filtered.whole[i], share * unfiltered, 0.1 * share * std::abs(unfiltered)) << i;
  }
}

TEST(AdaptationFilter, PassesSlowMotionAndDampsFastMotionAsAFirstOrderLowPass) {
  constexpr double kCorner = 5.0;
  const double share = filter_share(kCorner, kPeriod);
  const RobotModel arm = test::ur10();
  const Poses poses = test::poses_at(arm.chain, JointVector::Zero(6));
  for (const double frequency : {0.5, 5.0, 20.0}) {
    AdaptationFilter filter;
    filter.start(6);
    double largest = 0.0;
    SlotineLi along;
    for (int k = 0; k < 3000; ++k) {
      const JointVector x = JointVector::Constant(6, std::sin(2.0 * M_PI * frequency * k * kPeriod));
      filter.take(share, x, 2.0 * x, 3.0 * x);
      filter.motion(arm.chain, poses, along);
      EXPECT_NEAR(along.qdr[3], 2.0 * along.qd[3], 1e-12);
      EXPECT_NEAR(along.qddr[5], 3.0 * along.qd[5], 1e-12);
      if (k > 1500) largest = std::max(largest, std::abs(along.qd[0]));
    }
    // |1 / (1 + i f / f_c)|; a sampled filter, seen at its samples, differs by less than f T.
    const double gain = 1.0 / std::hypot(1.0, frequency / kCorner);
    EXPECT_NEAR(largest, gain, 0.05 * gain) << frequency;
  }
}

}  // namespace adaptation_test
}  // namespace armtune::internal
