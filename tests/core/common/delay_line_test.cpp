#include "core/common/delay_line.hpp"

#include <gtest/gtest.h>

namespace armtune::internal {
namespace delay_line_test {

class DelayLines : public testing::TestWithParam<int> {};

TEST_P(DelayLines, DelayByWholePeriodsAndBeginWithZero) {
  const int periods = GetParam();
  DelayLine delay(3, periods);
  for (int k = 0; k < 50; ++k) {
    const JointVector out = delay.pass(JointVector::Constant(3, k + 1.0));
    EXPECT_EQ(out, JointVector::Constant(3, k < periods ? 0.0 : k + 1.0 - periods)) << "period " << k;
  }
}

TEST_P(DelayLines, BeginWithTheGivenVector) {
  const int periods = GetParam();
  DelayLine delay(3, periods);
  delay.fill(JointVector::Constant(3, -7.0));
  for (int k = 0; k < 50; ++k) {
    const JointVector out = delay.pass(JointVector::Constant(3, k + 1.0));
    EXPECT_EQ(out, JointVector::Constant(3, k < periods ? -7.0 : k + 1.0 - periods)) << "period " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, DelayLines, testing::Values(0, 1, 2, 7));

}  // namespace delay_line_test
}  // namespace armtune::internal
