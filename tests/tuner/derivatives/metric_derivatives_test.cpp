// What the derivatives of a study's metrics consist of, and what they cost.

#include "tuner/derivatives/metric_derivatives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/core/support/refused_at.hpp"
#include "tests/tuner/derivatives/study_of_gains.hpp"

namespace armtune::internal {
namespace metric_derivatives_test {

using test::refused_at;
using test::study_of_gains;
using test::uses_of;

const std::atomic<bool> kNever{false};

/// Two scenarios of the UR10, one with a switch of the target.
Study two_scenarios(std::size_t gains) {
  Scenario tracked = test::scenario_of("moving_target", 6.0);
  Scenario switched = test::scenario_of("realistic_target_switch", 11.0);
  return study_of_gains({tracked, switched}, test::quick_gains(tracked), gains);
}

std::vector<std::uint64_t> bits_of(const MetricDerivatives& found) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  const auto add_all = [&](const Eigen::VectorXd& gradient, const std::vector<int>& missing) {
    for (const double x : gradient) add(x);
    for (const int gain : missing) add(gain);
  };
  for (const MetricDerivative& d : found.metrics) {
    add(d.value);
    add_all(d.gradient, d.missing);
    for (const SampleRow& row : d.rows) {
      add(row.value);
      add(row.time);
      add_all(row.gradient, row.missing);
    }
  }
  for (const MissingInterval& interval : found.missing) {
    add(interval.begin);
    add(interval.end);
    add(interval.gain);
  }
  for (const RolloutResult& result : found.results) {
    for (const double metric : result.metrics.value) add(metric);
  }
  add(found.simulated);
  return bits;
}

TEST(MetricDerivatives, AreBitIdenticalForAnyNumberOfWorkers) {
  const Study study = two_scenarios(5);
  const std::vector<double> x(5, 0.55);
  const auto uses = uses_of({Metric::kOrientationMax, Metric::kReacquisitionTime, Metric::kEffortRateRms}, 2);
  DerivativeOptions options;
  options.two_steps = true;
  std::optional<MetricDerivatives> first;
  for (const int count : {1, 2, 5}) {
    CandidateRunner workers(study.scenarios, study.stepper, count);
    const auto found = metric_derivatives(study, x, uses, workers, kNever, options);
    ASSERT_TRUE(found);
    if (!first) first = found;
    EXPECT_EQ(bits_of(*found), bits_of(*first)) << count << " workers";
    EXPECT_EQ(found->missing, first->missing);
  }
}

TEST(MetricDerivatives, CountEveryCopyInFull) {
  const Study study = two_scenarios(3);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::vector<double> x(3, 0.5);
  const auto found = metric_derivatives(study, x, uses_of({Metric::kPositionMax}, 2), workers, kNever);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rollouts, 2 * (1 + 3));
  EXPECT_DOUBLE_EQ(found->simulated, (1 + 3) * (6.0 + 11.0));
  EXPECT_EQ(workers.rollouts_done(), found->rollouts);
  EXPECT_DOUBLE_EQ(workers.simulated(), found->simulated);
}

TEST(MetricDerivatives, HaveTheValuesOfTheNativeEngine) {
  const Study study = two_scenarios(2);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::vector<double> x(2, 0.6);
  const auto uses = uses_of({Metric::kOrientationMax, Metric::kGazeRms}, 2);
  const auto found = metric_derivatives(study, x, uses, workers, kNever);
  ASSERT_TRUE(found);
  for (std::size_t s = 0; s < 2; ++s) {
    const RolloutResult alone =
        Rollout(study.scenarios[s], study.stepper, Engine::kNative).run(study.space.gains_at(x));
    EXPECT_EQ(test::bits(found->results[s].metrics), test::bits(alone.metrics));
    EXPECT_TRUE(found->results[s].series.metrics.empty());
  }
  for (const MetricDerivative& d : found->metrics) {
    EXPECT_EQ(d.value, found->results[d.use.scenario].metrics[d.use.metric]);
    if (d.shape != MetricShape::kLargest) continue;
    ASSERT_FALSE(d.rows.empty());
    EXPECT_EQ(d.rows.front().value, d.value);
    EXPECT_EQ(d.rows.front().gradient, d.gradient);
  }
}

TEST(MetricDerivatives, ConvertToTheUnitsOfTheGains) {
  const Study study = two_scenarios(2);  // the first gain on a linear scale, the second on a log scale
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::vector<double> x = {0.3, 0.7};
  const auto found = metric_derivatives(study, x, uses_of({Metric::kPositionRms}, 1), workers, kNever);
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < 2; ++i) {
    constexpr double kApart = 1e-6;
    std::vector<double> there = x;
    there[i] += kApart;
    const GainEntry& entry = study.space.free[i].entry;
    const double change = value(study.space.gains_at(there), entry) - value(study.space.gains_at(x), entry);
    EXPECT_NEAR(found->per_gain[static_cast<Eigen::Index>(i)], kApart / change, 1e-5 * kApart / change);
  }
}

TEST(MetricDerivatives, AreThoseOfSimbody) {
  const Study study = two_scenarios(3);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::vector<double> x(3, 0.5);
  const std::vector<Metric> metrics = {Metric::kOrientationRms, Metric::kPositionRms, Metric::kEffortRateRms};
  const auto found = metric_derivatives(study, x, uses_of(metrics, 1), workers, kNever);
  ASSERT_TRUE(found);
  Rollout simbody(study.scenarios[0], study.stepper);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr double kApart = 1e-4;
    std::vector<double> above = x;
    std::vector<double> below = x;
    above[i] += kApart;
    below[i] -= kApart;
    const RolloutResult high = simbody.run(study.space.gains_at(above));
    const RolloutResult low = simbody.run(study.space.gains_at(below));
    for (const MetricDerivative& d : found->metrics) {
      if (!d.missing.empty()) continue;
      const double expected = (high.metrics[d.use.metric] - low.metrics[d.use.metric]) / (2.0 * kApart);
      // The engines' dynamics differ by rounding, and the difference by its truncation and by events between.
      EXPECT_NEAR(d.gradient[static_cast<Eigen::Index>(i)], expected,
                  0.01 * d.gradient.lpNorm<Eigen::Infinity>())
          << name(d.use.metric) << " by gain " << i;
    }
  }
}

TEST(MetricDerivatives, OfTheReacquisitionTimeAreNotRoundedToPeriods) {
  const Study study = two_scenarios(8);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::vector<double> x(study.space.free.size(), 0.5);
  const auto found = metric_derivatives(study, x, {{Metric::kReacquisitionTime, 1}}, workers, kNever);
  ASSERT_TRUE(found);
  const MetricDerivative& time = found->metrics.front();
  EXPECT_EQ(time.shape, MetricShape::kTime);
  EXPECT_GT(time.value, 0.0);
  EXPECT_GT(time.gradient.lpNorm<Eigen::Infinity>(), 0.0) << "a time in whole periods has no slope";
}

TEST(MetricDerivatives, MarkAnEventThatALargeStepMoves) {
  Study study = two_scenarios(1);
  const GainEntry slerp = [&] {
    for (const GainEntry& entry : gain_entries(study.space.start, joint_names(*study.scenarios[0].robot))) {
      if (entry.name == "slerpDurationErrorGain") return entry;
    }
    return GainEntry();
  }();
  const double v = value(study.space.start, slerp);
  study.space.free = {{slerp, v, 0.2 * v, 5.0 * v, Scale::kLog}};
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  DerivativeOptions options;
  options.step = 0.05;  // the slerp to the other target takes some periods longer
  const auto found =
      metric_derivatives(study, {0.5}, {{Metric::kOrientationMax, 1}}, workers, kNever, options);
  ASSERT_TRUE(found);
  const auto of_slerp =
      std::find_if(found->missing.begin(), found->missing.end(), [](const MissingInterval& i) {
        return i.cause == EventCause::kSlerp || i.cause == EventCause::kState;
      });
  ASSERT_NE(of_slerp, found->missing.end());
  EXPECT_EQ(of_slerp->scenario, 1U);
  EXPECT_EQ(of_slerp->gain, 0);
  EXPECT_DOUBLE_EQ(of_slerp->end, study.scenarios[1].duration);
  for (const SampleRow& row : found->metrics.front().rows) {
    if (row.time < of_slerp->begin) continue;
    EXPECT_THAT(row.missing, testing::ElementsAre(0)) << row.time;
    EXPECT_EQ(row.gradient[0], 0.0);
  }
}

TEST(MetricDerivatives, OfTwoStepsThatDisagreeAreMissing) {
  const Study study = two_scenarios(2);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  DerivativeOptions options;
  options.two_steps = true;
  const std::vector<double> x(2, 0.4);
  const auto uses = uses_of({Metric::kOrientationRms}, 1);
  const auto near = metric_derivatives(study, x, uses, workers, kNever, options);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->rollouts, 2 + 2 * 2) << "the second scenario has no metric, so no copies";
  EXPECT_TRUE(near->metrics.front().missing.empty());
  options.step = 0.1;  // far beyond the range in which the metric is linear
  const auto far = metric_derivatives(study, x, uses, workers, kNever, options);
  ASSERT_TRUE(far);
  EXPECT_FALSE(far->metrics.front().missing.empty());
}

TEST(MetricDerivatives, GoDownwardsAtTheUpperBound) {
  const Study study = two_scenarios(1);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const auto uses = uses_of({Metric::kPositionRms}, 1);
  const auto at_bound = metric_derivatives(study, {1.0}, uses, workers, kNever);
  const auto inside = metric_derivatives(study, {1.0 - 1e-5}, uses, workers, kNever);
  ASSERT_TRUE(at_bound && inside);
  const double there = inside->metrics[0].gradient[0];
  EXPECT_NE(there, 0.0);
  EXPECT_NEAR(at_bound->metrics[0].gradient[0], there, 1e-3 * std::abs(there));
}

TEST(MetricDerivatives, AreThoseOfEachRandomArm) {
  Study study = two_scenarios(2);
  study.scenarios.resize(1);
  study.robust = SampleSet{};
  study.robust->samples = 2;
  study.robust->measure = RiskMeasure::kWorst;
  CandidateRunner workers(study.scenarios, study.stepper, 2, study.robust);
  const std::vector<double> x(2, 0.5);
  const auto found = metric_derivatives(study, x, {{Metric::kOrientationMax, 0}}, workers, kNever);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->metrics.size(), 3U);
  EXPECT_EQ(found->rollouts, 3 * (1 + 2));
  double worst = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_EQ(found->metrics[a].arm, a);
    worst = std::max(worst, found->metrics[a].value);
    EXPECT_NE(found->metrics[a].value, found->metrics[(a + 1) % 3].value);
  }
  EXPECT_EQ(found->results[0].metrics[Metric::kOrientationMax], worst);
}

TEST(MetricDerivatives, EndWhenStopped) {
  const Study study = two_scenarios(1);
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(metric_derivatives(study, {0.5}, uses_of({Metric::kPositionRms}, 1), workers, stop));
}

TEST(MetricDerivatives, RefuseStepsAndPointsOutsideTheirRange) {
  Study study = two_scenarios(1);
  CandidateRunner workers(study.scenarios, study.stepper, 1);
  const auto with = [&](const std::vector<double>& x, const DerivativeOptions& options) {
    return
        [&study, &workers, x, options] { return metric_derivatives(study, x, {}, workers, kNever, options); };
  };
  DerivativeOptions wide;
  wide.step = 0.2;
  EXPECT_THAT(with({0.5}, wide), refused_at({.key = "step", .value = "0.2"}));
  EXPECT_THAT(with({0.5, 0.5}, {}), refused_at({.key = "x", .value = "2"}));
  EXPECT_THAT(with({1.5}, {}), refused_at({.key = "x", .value = "1.5"}));
  study.stepper = Stepper::kReference;
  EXPECT_THAT(with({0.5}, {}), refused_at({.key = "search/stepper"}));
}

TEST(MetricsInUse, AreThoseOfTermsAndConstraintsWhereTheyApply) {
  Study study;
  study.scenarios = {test::scenario_of("moving_target", 6.0), test::scenario_of("obstacle_pass", 6.0)};
  study.terms = {{Metric::kOrientationMax, 1.0, 0.0, {1}}, {Metric::kPositionRms, 1.0, 0.0, {0, 1}}};
  study.constraints = {{Metric::kObstacleMinClearance, false, 0.1, {0, 1}},
                       {Metric::kPositionRms, true, 0.1, {0}}};
  EXPECT_THAT(metrics_in_use(study),
              testing::UnorderedElementsAre(
                  MetricUse{Metric::kOrientationMax, 1}, MetricUse{Metric::kPositionRms, 0},
                  MetricUse{Metric::kPositionRms, 1}, MetricUse{Metric::kObstacleMinClearance, 1}));
}

TEST(MetricsInUse, OfAMarginAreThoseByWhichItsCornerIsJudged) {
  Study study;
  study.scenarios = {test::scenario_of("moving_target", 6.0)};
  study.margins = {{MarginKind::kTorqueDelay, 1.0}};
  Constraint& margin = study.constraints.emplace_back();
  margin.scenarios = {1};  // the corner
  margin.margin = study.margins[0];
  EXPECT_THAT(metrics_in_use(study), testing::ElementsAre(MetricUse{Metric::kJointVelocityMaxRatio, 1},
                                                          MetricUse{Metric::kJointPositionMinMargin, 1}));
}

}  // namespace metric_derivatives_test
}  // namespace armtune::internal
