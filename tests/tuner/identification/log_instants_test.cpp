#include "tuner/identification/log_instants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace armtune::internal {
namespace {

/// A log of white noise of standard deviation 1 on a slow sine, whose filters have this norm.
void add_log(LogInstants& instants, unsigned seed, int samples, double filter_norm) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  instants.begin_log(filter_norm);
  for (int k = 0; k < samples; ++k)
    instants.add_logged_torque(JointVector::Constant(1, 20.0 * std::sin(1e-3 * k) + normal(generator)));
}

TEST(LogInstants, KnowTheNoiseOfFilteredTorques) {
  for (const double norm : {1.0, 0.2}) {
    LogInstants instants;
    add_log(instants, 3, 2000, norm);
    EXPECT_NEAR(instants.torque_noise()[0], norm, 0.05 * norm);
  }
}

// The filters of two logs differ if their rates do. The noise must not depend on which log came last.
TEST(LogInstants, TheNoiseOfSeveralLogsDoesNotDependOnTheirOrder) {
  LogInstants one, other;
  add_log(one, 3, 1000, 0.5);
  add_log(one, 4, 1000, 0.05);
  add_log(other, 4, 1000, 0.05);
  add_log(other, 3, 1000, 0.5);
  EXPECT_EQ(one.torque_noise(), other.torque_noise());
  EXPECT_GT(one.torque_noise()[0], 0.05);
  EXPECT_LT(one.torque_noise()[0], 0.5);
}

TEST(LogInstants, WithFewerThanThreeSamplesTheNoiseIsNotKnown) {
  LogInstants instants;
  add_log(instants, 3, 2, 0.5);
  EXPECT_EQ(instants.torque_noise().size(), 0);
}

}  // namespace
}  // namespace armtune::internal
