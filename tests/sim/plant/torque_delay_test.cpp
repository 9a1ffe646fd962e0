#include "sim/plant/torque_delay.hpp"

#include <gtest/gtest.h>

namespace armtune::internal {
namespace {

class TorqueDelayed : public testing::TestWithParam<int> {};

TEST_P(TorqueDelayed, ByWholePeriodsAndZeroBefore) {
  const int periods = GetParam();
  TorqueDelay delay(3, periods);
  for (int k = 0; k < 50; ++k) {
    const JointVector out = delay.pass(JointVector::Constant(3, k + 1.0));
    EXPECT_EQ(out, JointVector::Constant(3, k < periods ? 0.0 : k + 1.0 - periods)) << "period " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, TorqueDelayed, testing::Values(0, 1, 2, 7));

}  // namespace
}  // namespace armtune::internal
