// Rates, gaps and ranges of a log that streams by.

#include "sim/logs/log_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/logs/log_selection.hpp"

namespace armtune::internal {
namespace log_summary_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Summary, CountsGapsAndFindsTheRate) {
  TopicAccumulator accumulator;
  double time = 5.0;
  for (int k = 0; k < 1000; ++k) {
    accumulator.add_time(time);
    time += k % 250 == 100 ? 0.05 : 0.002;  // 4 gaps
  }
  const TopicSummary topic = accumulator.finish();
  EXPECT_EQ(topic.rows, 1000);
  EXPECT_NEAR(topic.rate(), 500.0, 1e-6);
  EXPECT_EQ(topic.steps.gaps, 4);
  EXPECT_NEAR(topic.steps.longest, 0.05, 1e-9);
  EXPECT_LT(topic.steps.jitter, 1e-6);
  EXPECT_EQ(topic.first, 5.0);
}

TEST(Summary, MeasuresJitter) {
  TopicAccumulator accumulator;
  double time = 0.0;
  for (int k = 0; k < 1000; ++k) {
    accumulator.add_time(time);
    time += k % 3 == 0 ? 0.008 : k % 3 == 1 ? 0.010 : 0.012;
  }
  const TopicSummary topic = accumulator.finish();
  EXPECT_NEAR(topic.steps.median, 0.01, 1e-9);
  EXPECT_NEAR(topic.steps.jitter, 0.2, 1e-6);
  EXPECT_EQ(topic.steps.gaps, 0);
}

TEST(Summary, CountsRepeatedAndLateRows) {
  TopicAccumulator accumulator;
  for (const double time : {0.0, 0.1, 0.1, 0.3, 0.2, 0.4}) accumulator.add_time(time);
  const TopicSummary topic = accumulator.finish();
  EXPECT_EQ(topic.repeated, 1);
  EXPECT_EQ(topic.backward, 1);
  EXPECT_EQ(topic.last, 0.4);
}

TEST(Summary, TakesStepsOfAnySize) {
  StepHistogram steps;
  for (const double step : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity(), 1e300, 1e-300})
    steps.add(step);
  EXPECT_EQ(steps.summary().longest, 1e300);
  EXPECT_EQ(StepHistogram().summary().median, 0.0);
}

TEST(Summary, KeepsRangesAndMissingNumbers) {
  TopicAccumulator accumulator;
  accumulator.add_channel("a", "rad");
  for (int k = 0; k < 10; ++k) {
    if (k == 4) accumulator.add_channel("late", "");
    accumulator.add_time(0.1 * k);
    accumulator.add_values(k < 4 ? std::vector{k == 2 ? kNaN : 1.0 * k} : std::vector{1.0 * k, 7.0});
  }
  const TopicSummary topic = accumulator.finish();
  EXPECT_EQ(topic.channels[0].least, 0.0);
  EXPECT_EQ(topic.channels[0].greatest, 9.0);
  EXPECT_EQ(topic.channels[0].missing, 1);
  EXPECT_FALSE(topic.channels[0].constant());
  EXPECT_EQ(topic.channels[1].missing, 4);
  EXPECT_TRUE(topic.channels[1].constant());
}

TEST(Summary, KeepsABoundedNumberOfStretches) {
  for (const std::size_t channels : {1U, 5000U}) {
    MotionBlocks blocks;
    std::vector<double> value(channels);
    const int rows = channels == 1 ? 200'000 : 3000;
    for (int k = 0; k < rows; ++k) {
      value.front() = std::sin(0.01 * k);
      blocks.add(0.01 * k, value);
    }
    EXPECT_LE(blocks.size() * channels, std::size_t{1} << 18U);
    EXPECT_GE(blocks.size(), 16U);
  }
}

TEST(Summary, FindsDerivativesInALongLog) {
  MotionBlocks blocks;
  for (int k = 0; k < 300'000; ++k) {
    const double t = 0.01 * k;
    blocks.add(t, {std::sin(t), std::cos(t), 3.0 * std::sin(t)});
  }
  // The trapezoidal rule over steps of 0.01 s is accurate to 1e-5 here.
  EXPECT_NEAR(blocks.derivative(0, 1).factor, 1.0, 1e-4);
  EXPECT_GT(blocks.derivative(0, 1).correlation, 0.9999);
  EXPECT_LT(std::abs(blocks.derivative(0, 2).correlation), 0.2);
  EXPECT_NEAR(blocks.multiple(0, 2).factor, 3.0, 1e-9);
}

TEST(Pattern, MatchesAllOfTheText) {
  EXPECT_TRUE(matches_pattern("/joint_states", "/joint_states"));
  EXPECT_TRUE(matches_pattern("/*/state", "/arm/a/state"));
  EXPECT_TRUE(matches_pattern("*", ""));
  EXPECT_TRUE(matches_pattern("/a?c*", "/abc"));
  EXPECT_FALSE(matches_pattern("/joint", "/joint_states"));
  EXPECT_FALSE(matches_pattern("/*/state", "/arm/states"));
  EXPECT_FALSE(matches_pattern("", "a"));
  // A matcher that tries all ways would take hours here.
  EXPECT_FALSE(matches_pattern("*a*a*a*a*a*a*a*a*a*a*a*b", std::string(5000, 'a')));
}

}  // namespace log_summary_test
}  // namespace armtune::internal
