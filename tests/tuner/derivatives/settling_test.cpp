#include "tuner/derivatives/settling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace settling_test {

/// A gaze error beyond its threshold in periods of 0.5 s. The target switches in these periods.
struct Gaze {
  Gaze(std::vector<double> values, const std::vector<std::size_t>& switches) {
    rollout.period = 0.5;
    PeriodMode target = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (const std::size_t s : switches) target += s == k ? 1U : 0U;
      rollout.modes.push_back(target << kFirstTargetBit);
    }
    series.metric = Metric::kReacquisitionTime;
    series.values = std::move(values);
  }
  RolloutSeries rollout;
  MetricSeries series;
};

TEST(Settling, CrossesZeroBetweenTwoPeriods) {
  const Gaze gaze({-1.0, 4.0, 3.0, -1.0, -1.0}, {1});
  const auto found = longest_settling(gaze.rollout, gaze.series);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->event, 1U);
  EXPECT_EQ(found->period, 3U);
  EXPECT_DOUBLE_EQ(found->time, 0.5 * 1.75);  // three quarters of the way from 3 to -1
}

TEST(Settling, CountsFromTheLastPeriodOutside) {
  const Gaze gaze({-1.0, 4.0, -1.0, 1.0, -1.0, -2.0}, {1});
  EXPECT_DOUBLE_EQ(longest_settling(gaze.rollout, gaze.series)->time, 0.5 * 2.5);
}

TEST(Settling, IsTheLongestOfAllEvents) {
  const Gaze gaze({-1.0, 1.0, -1.0, -1.0, 3.0, 3.0, 1.0, -1.0}, {1, 4});
  const auto found = longest_settling(gaze.rollout, gaze.series);
  EXPECT_EQ(found->event, 4U);
  EXPECT_DOUBLE_EQ(found->time, 0.5 * 2.5);
  EXPECT_DOUBLE_EQ(settling_after(gaze.rollout, gaze.series, 1).time, 0.5 * 0.5);
}

TEST(Settling, ThatNeverHappensLastsToTheNextEventOrTheEnd) {
  const Gaze gaze({-1.0, 1.0, 1.0, 2.0, 2.0, 2.0}, {1, 3});
  EXPECT_DOUBLE_EQ(settling_after(gaze.rollout, gaze.series, 1).time, 0.5 * 2.0);
  EXPECT_DOUBLE_EQ(settling_after(gaze.rollout, gaze.series, 3).time, 0.5 * 3.0);
}

TEST(Settling, OfAGazeThatStaysInsideTakesNoTime) {
  const Gaze gaze({-1.0, -2.0, -1.0}, {1});
  EXPECT_EQ(longest_settling(gaze.rollout, gaze.series)->time, 0.0);
}

TEST(Settling, NeedsAnEventWithAValue) {
  EXPECT_FALSE(longest_settling(Gaze({-1.0, 1.0}, {}).rollout, Gaze({-1.0, 1.0}, {}).series));
  const Gaze early({NAN, NAN, 1.0}, {1});
  EXPECT_FALSE(longest_settling(early.rollout, early.series));
}

TEST(Settling, AtAGoalBeginsWithTheFirstValue) {
  Gaze gaze({NAN, NAN, 2.0, -2.0}, {});
  gaze.series.metric = Metric::kGoalSettlingTime;
  const auto found = longest_settling(gaze.rollout, gaze.series);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->event, 2U);
  EXPECT_DOUBLE_EQ(found->time, 0.25);
}

}  // namespace settling_test
}  // namespace armtune::internal
