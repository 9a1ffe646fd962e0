// Derivatives from two rollouts that are written by hand, and events planted between them.

#include "tuner/derivatives/rollout_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace rollout_difference_test {

using testing::Test;

constexpr double kStep = 0.5;
constexpr std::size_t kPeriods = 6;

/// A rollout of six periods of 0.1 s: a largest value, its RMS, and a time without a series.
RolloutResult rollout(const std::vector<double>& values) {
  RolloutResult r;
  r.series.period = 0.1;
  r.series.modes.assign(values.size(), 2);
  double squares = 0.0;
  double largest = NAN;
  double counted = 0.0;
  for (const double x : values) {
    largest = std::fmax(largest, x);
    if (!std::isnan(x)) squares += x * x;
    if (!std::isnan(x)) counted += 1.0;
  }
  for (const Metric metric : {Metric::kPositionMax, Metric::kPositionRms}) {
    r.series.metrics.push_back({metric, 1, values});
  }
  r.metrics[Metric::kPositionMax] = largest;
  r.metrics[Metric::kPositionRms] = std::sqrt(squares / counted);
  r.metrics[Metric::kResponseRiseTime] = largest * largest;
  return r;
}

/// The derivative by gain 1 of three.
MetricDerivative derivative(Metric metric, const RolloutResult& base, const RolloutResult& copy) {
  MetricDerivative d;
  d.use.metric = metric;
  d.shape = shape_of(metric);
  d.value = base.metrics[metric];
  d.gradient = Eigen::VectorXd::Zero(3);
  if (d.shape == MetricShape::kLargest) {
    for (const std::size_t k : {std::size_t{4}, std::size_t{1}}) {
      d.rows.push_back({k, 0, 0.1 * static_cast<double>(k), base.series.metrics[0].at(k), d.gradient, {}});
    }
  }
  RolloutDifference(base, copy, kStep).differentiate(1, d);
  return d;
}

class Differences : public Test {
 protected:
  const RolloutResult base_ = rollout({NAN, 3.0, 1.0, 2.0, 4.0, 1.0});
  RolloutResult copy_ = rollout({NAN, 3.5, 1.0, 2.0, 4.25, 1.0});
  std::vector<MissingInterval> missing() const { return RolloutDifference(base_, copy_, kStep).missing(); }
};

TEST_F(Differences, OfALargestValueAreThoseOfItsRows) {
  const MetricDerivative d = derivative(Metric::kPositionMax, base_, copy_);
  EXPECT_EQ(d.gradient, Eigen::Vector3d(0.0, 0.5, 0.0));
  EXPECT_EQ(d.rows[0].gradient, Eigen::Vector3d(0.0, 0.5, 0.0));
  EXPECT_EQ(d.rows[1].gradient, Eigen::Vector3d(0.0, 1.0, 0.0));
  EXPECT_TRUE(d.missing.empty());
  EXPECT_TRUE(missing().empty());
}

TEST_F(Differences, OfAnRmsAreItsDerivative) {
  // rms^2 = sum s^2 / 5, so d rms = sum s ds / (5 rms)
  const double expected = (3.0 * 0.5 + 4.0 * 0.25) / (5.0 * base_.metrics[Metric::kPositionRms]) / kStep;
  EXPECT_NEAR(derivative(Metric::kPositionRms, base_, copy_).gradient[1], expected, 1e-14);
}

TEST_F(Differences, OfOtherMetricsAreThoseOfTheWhole) {
  EXPECT_DOUBLE_EQ(derivative(Metric::kResponseRiseTime, base_, copy_).gradient[1],
                   (4.25 * 4.25 - 16.0) / kStep);
}

TEST_F(Differences, DoNotExistAfterAStateChangedInAnotherPeriod) {
  copy_.series.modes[3] = 1;
  const MetricDerivative largest = derivative(Metric::kPositionMax, base_, copy_);
  EXPECT_EQ(largest.rows[0].missing, std::vector<int>{1});
  EXPECT_EQ(largest.rows[0].gradient[1], 0.0);
  EXPECT_TRUE(largest.rows[1].missing.empty()) << "the row before the event";
  EXPECT_EQ(largest.missing, std::vector<int>{1}) << "the first row is the largest value";
  EXPECT_EQ(derivative(Metric::kPositionRms, base_, copy_).missing, std::vector<int>{1});
  EXPECT_EQ(derivative(Metric::kResponseRiseTime, base_, copy_).missing, std::vector<int>{1});
  ASSERT_EQ(missing().size(), 1U);
  EXPECT_DOUBLE_EQ(missing()[0].begin, 0.3);
  EXPECT_DOUBLE_EQ(missing()[0].end, 0.6);
  EXPECT_EQ(missing()[0].cause, EventCause::kState);
}

TEST_F(Differences, DoNotExistWhereATorqueSaturatesInOneOfTheTwo) {
  copy_.series.modes[1] |= PeriodMode{1} << kFirstSaturatedBit;
  const MetricDerivative largest = derivative(Metric::kPositionMax, base_, copy_);
  EXPECT_TRUE(largest.missing.empty()) << "saturation ends with its periods";
  EXPECT_EQ(largest.rows[1].missing, std::vector<int>{1});
  EXPECT_TRUE(derivative(Metric::kPositionRms, base_, copy_).missing.empty());
  ASSERT_EQ(missing().size(), 1U);
  EXPECT_DOUBLE_EQ(missing()[0].begin, 0.1);
  EXPECT_DOUBLE_EQ(missing()[0].end, 0.2);
  EXPECT_EQ(missing()[0].cause, EventCause::kSaturation);
}

TEST_F(Differences, NameTheCauseOfEachInterval) {
  copy_.series.modes[1] |= kModeDamped;
  copy_.series.modes[2] |= kModeSlowed;
  copy_.series.modes[5] |= kModeSlerping;
  const auto found = missing();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].cause, EventCause::kDampedInverse);
  EXPECT_EQ(found[1].cause, EventCause::kSlowedReference);
  EXPECT_DOUBLE_EQ(found[1].end, 0.3);
  EXPECT_EQ(found[2].cause, EventCause::kSlerp);
}

TEST_F(Differences, DoNotExistAfterTheEndOfACopy) {
  copy_ = rollout({NAN, 3.5, 1.0});
  const MetricDerivative largest = derivative(Metric::kPositionMax, base_, copy_);
  EXPECT_EQ(largest.missing, std::vector<int>{1});
  EXPECT_TRUE(largest.rows[1].missing.empty());
  EXPECT_EQ(derivative(Metric::kPositionRms, base_, copy_).missing, std::vector<int>{1});
  ASSERT_EQ(missing().size(), 1U);
  EXPECT_EQ(missing()[0].cause, EventCause::kEnd);
  EXPECT_DOUBLE_EQ(missing()[0].end, 0.1 * kPeriods);
}

TEST_F(Differences, OfAnRmsOverOtherPeriodsDoNotExist) {
  copy_ = rollout({1.0, 3.5, 1.0, 2.0, 4.25, 1.0});
  EXPECT_EQ(derivative(Metric::kPositionRms, base_, copy_).missing, std::vector<int>{1});
}

}  // namespace rollout_difference_test
}  // namespace armtune::internal
