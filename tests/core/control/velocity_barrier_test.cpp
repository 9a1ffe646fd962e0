#include "core/control/velocity_barrier.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace velocity_barrier_test {

using test::random_vector;

constexpr int kJoints = 6;
constexpr double kStart = 0.8;
constexpr double kGain = 2.0;

/// Joints from rest to beyond their limits, and torques of every sign.
struct Sample {
  JointVector limits, qd, Kd, bypassing, torque;

  JointVector added(double gain) const {
    JointVector result = torque;
    add_behind_barrier(qd, limits, kStart, gain, Kd, bypassing, result);
    return result - torque;
  }
};

template <typename Check>
void for_all_samples(unsigned seed, const Check& check) {
  std::mt19937 generator(seed);
  for (int sample = 0; sample < 200; ++sample) {
    Sample s;
    s.limits = random_vector(generator, kJoints, 1.0) + JointVector::Constant(kJoints, 2.0);
    s.qd = random_vector(generator, kJoints, 1.3).cwiseProduct(s.limits);
    s.Kd = random_vector(generator, kJoints, 50.0) + JointVector::Constant(kJoints, 60.0);
    s.bypassing = random_vector(generator, kJoints, 100.0);
    s.torque = random_vector(generator, kJoints, 100.0);
    check(s);
  }
}

double share(const Sample& s, int joint) {
  return std::abs(s.qd[joint]) / s.limits[joint];
}

TEST(VelocityBarrier, IsZeroUpToItsStartAndOneFromTheLimitOn) {
  for (const double start : {0.0, 0.5, 0.8, 0.99}) {
    for (const double limit : {0.3, 2.0}) {
      for (const double sign : {-1.0, 1.0}) {
        EXPECT_EQ(velocity_barrier(0.0, limit, start), 0.0);
        EXPECT_EQ(velocity_barrier(sign * start * limit * (1.0 - 1e-15), limit, start), 0.0);
        EXPECT_GT(velocity_barrier(sign * (start + 1e-6) * limit, limit, start), 0.0);
        EXPECT_LT(velocity_barrier(sign * (1.0 - 1e-6) * limit, limit, start), 1.0);
        EXPECT_EQ(velocity_barrier(sign * 1.001 * limit, limit, start), 1.0);
        EXPECT_EQ(velocity_barrier(sign * 100.0 * limit, limit, start), 1.0);
      }
    }
  }
}

TEST(VelocityBarrier, GrowsWithTheSpeedAndIsFlatAtBothEnds) {
  double last = 0.0;
  for (int step = 1; step < 40; ++step) {
    const double x = kStart + 0.005 * step;
    const double h = velocity_barrier(x, 1.0, kStart);
    EXPECT_GT(h, last) << x;
    EXPECT_EQ(velocity_barrier(-x, 1.0, kStart), h) << x;
    last = h;
  }
  // Slopes that vanish: 3 (distance / 0.2)^2 is second order in the distance.
  EXPECT_LT(velocity_barrier(0.8 + 1e-4, 1.0, kStart), 1e-6);
  EXPECT_GT(velocity_barrier(1.0 - 1e-4, 1.0, kStart), 1.0 - 1e-6);
}

TEST(VelocityBarrier, TakesPowerFromEveryJointThatIsBeyondItsStartAndFromNoOther) {
  int beyond = 0;
  for_all_samples(731, [&](Sample s) {
    s.bypassing.setZero();
    const JointVector added = s.added(kGain);
    for (int i = 0; i < kJoints; ++i) {
      if (share(s, i) > kStart + 1e-3) {
        ++beyond;
        EXPECT_LT(added[i] * s.qd[i], 0.0);
      } else if (share(s, i) < kStart) {
        EXPECT_EQ(added[i], 0.0);
      }
    }
  });
  EXPECT_GT(beyond, 100);
}

TEST(VelocityBarrier, DampsWhatIsBeyondItsStartWithTheGainTimesKdFromTheLimitOn) {
  test::WorstError worst("damping", 1e-13);  // rounding
  for_all_samples(732, [&](Sample s) {
    s.bypassing.setZero();
    const JointVector added = s.added(kGain);
    for (int i = 0; i < kJoints; ++i) {
      if (share(s, i) >= 1.0) {
        const double beyond = (share(s, i) - kStart) * s.limits[i];
        worst.compare(added[i], std::copysign(kGain * s.Kd[i] * beyond, -s.qd[i]), "beyond the limit", 1.0);
      }
    }
  });
}

TEST(VelocityBarrier, IsNowhereMuchSteeperThanKd) {
  // The largest slope of h(x) x with h = 3 x^2 - 2 x^3 up to 1 and 1 beyond: 9 x^2 - 8 x^3 at x = 3/4.
  constexpr double kSteepest = 27.0 / 16.0;
  Sample s;
  s.limits = s.Kd = JointVector::Ones(1);
  s.bypassing = s.torque = JointVector::Zero(1);
  const auto torque = [&s](double qd) {
    s.qd = JointVector::Constant(1, qd);
    return s.added(1.0)[0];
  };
  double steepest = 0.0;
  for (double qd = 0.7; qd < 1.3; qd += 1e-3) {
    steepest = std::max(steepest, (torque(qd) - torque(qd + 1e-6)) / 1e-6);
  }
  EXPECT_NEAR(steepest, kSteepest, 1e-3);
}

TEST(VelocityBarrier, FadesOutWhatPushesAJointOnAndNothingElse) {
  test::WorstError worst("bypassing torque", 1e-13);  // rounding
  int pushed = 0;
  int braked = 0;
  for_all_samples(733, [&](const Sample& s) {
    Sample alone = s;
    alone.bypassing.setZero();
    const JointVector passed = s.added(kGain) - alone.added(kGain);
    for (int i = 0; i < kJoints; ++i) {
      const bool on = s.bypassing[i] * s.qd[i] > 0.0;
      if (on && share(s, i) > kStart) {
        ++pushed;
        const double h = velocity_barrier(s.qd[i], s.limits[i], kStart);
        worst.compare(passed[i], (1.0 - h) * s.bypassing[i], "pushes on", 100.0);
      } else {
        braked += on ? 0 : 1;
        worst.compare(passed[i], s.bypassing[i], "brakes or is slow", 100.0);
      }
    }
  });
  EXPECT_GT(pushed, 100);
  EXPECT_GT(braked, 100);
}

TEST(VelocityBarrier, WithoutGainAddsWhatBypassesTheReferenceAsItIs) {
  for_all_samples(734, [](const Sample& s) {
    JointVector result = s.torque;
    add_behind_barrier(s.qd, s.limits, kStart, 0.0, s.Kd, s.bypassing, result);
    EXPECT_EQ(result, JointVector(s.torque + s.bypassing));
  });
}

}  // namespace velocity_barrier_test
}  // namespace armtune::internal
