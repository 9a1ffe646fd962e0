// The series behind the metrics are those from which the metrics are computed.

#include "sim/metrics/series_recorder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/support/law_jobs.hpp"

namespace armtune::internal {
namespace series_recorder_test {

using test::bits;

/// Returns the metric that follows from its series. An RMS is relative to the root of the sum of squares.
double from_series(const MetricSeries& series) {
  double found = NAN;
  for (const double x : series.values) {
    if (std::isnan(x)) continue;
    switch (*series_kind(series.metric)) {
      case SeriesKind::kLargest:
        found = std::fmax(found, x);
        break;
      case SeriesKind::kSmallest:
        found = std::fmin(found, x);
        break;
      default:
        found = (std::isnan(found) ? 0.0 : found) + x * x;
    }
  }
  return found;
}

std::vector<RolloutResult> recorded_rollouts() {
  std::vector<RolloutResult> all;
  for (const char* name : {"realistic_target_switch", "realistic_obstacle_pass", "panda_moving_target"}) {
    const Scenario scenario = test::scenario_of(name, 12.0);
    all.push_back(Rollout(scenario, Stepper::kMidpoint, Engine::kNative)
                      .run(test::bundled_gains(scenario), {}, {}, all_metrics()));
  }
  const Scenario planned = test::with_plan(test::scenario_of("moving_target", 5.0));
  all.push_back(Rollout(planned, Stepper::kMidpoint, Engine::kNative)
                    .run(test::gains_of(planned, "position_streaming"), {}, {}, all_metrics()));
  return all;
}

TEST(RecordedSeries, HaveTheirMetricAsExtremeValue) {
  int compared = 0;
  for (const RolloutResult& result : recorded_rollouts()) {
    for (const MetricSeries& series : result.series.metrics) {
      const SeriesKind kind = *series_kind(series.metric);
      EXPECT_EQ(series.periods(), result.series.modes.size()) << name(series.metric);
      if (kind != SeriesKind::kLargest && kind != SeriesKind::kSmallest) continue;
      const double metric = result.metrics[series.metric];
      const double found = from_series(series);
      ASSERT_EQ(std::isnan(found), std::isnan(metric)) << name(series.metric);
      if (std::isnan(metric)) continue;
      // The metric is scaled after the extreme was found, the series before: a rounding error of each
      // product.
      EXPECT_NEAR(found, metric, 1e-12 * std::abs(metric)) << name(series.metric);
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

TEST(RecordedSeries, HaveTheirMetricAsRootMeanSquare) {
  for (const RolloutResult& result : recorded_rollouts()) {
    const MetricSeries& position = *result.series.find(Metric::kPositionRms);
    const double samples = result.metrics[Metric::kSamples];
    if (samples == 0.0) continue;  // the tool does not track its path after the planned motion yet
    EXPECT_NEAR(std::sqrt(from_series(position) / samples), result.metrics[Metric::kPositionRms],
                1e-12 * result.metrics[Metric::kPositionRms]);
    // The ratio of two RMS values over the same periods needs no number of periods.
    const MetricSeries& orientation = *result.series.find(Metric::kOrientationRms);
    EXPECT_NEAR(std::sqrt(from_series(orientation) / from_series(position)),
                result.metrics[Metric::kOrientationRms] / result.metrics[Metric::kPositionRms],
                1e-9 * result.metrics[Metric::kOrientationRms] / result.metrics[Metric::kPositionRms]);
  }
}

TEST(RecordedSeries, ChangeNoResult) {
  const Scenario scenario = test::scenario_of("realistic_target_switch", 6.0);
  const Gains gains = test::quick_gains(scenario);
  Rollout rollout(scenario, Stepper::kMidpoint, Engine::kNative);
  const RolloutResult without = rollout.run(gains);
  const RolloutResult with = rollout.run(gains, {}, {}, all_metrics());
  EXPECT_EQ(bits(with.metrics), bits(without.metrics));
  EXPECT_TRUE(without.series.metrics.empty());
  EXPECT_TRUE(without.series.modes.empty());
  EXPECT_EQ(with.series.modes.size(), static_cast<std::size_t>(scenario.periods()));
}

TEST(RecordedSeries, OfArmsSideBySideAreThoseOfEachAlone) {
  std::vector<LaneJob> jobs;
  const Scenario scenario = test::scenario_of("realistic_target_switch", 9.0);
  for (const double factor : {1.0, 0.9, 1.1}) {
    Gains gains = test::quick_gains(scenario);
    gains.task_space_gains_p *= factor;
    jobs.push_back(test::job_of(scenario, gains));
    jobs.back().series = all_metrics();
  }
  const auto found = test::side_by_side(jobs, 3, best_processor(), Stepper::kMidpoint);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const RolloutResult alone =
        Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(jobs[i].gains, {}, {}, all_metrics());
    EXPECT_EQ(found[i].series.modes, alone.series.modes);
    ASSERT_EQ(found[i].series.metrics.size(), alone.series.metrics.size());
    for (std::size_t m = 0; m < alone.series.metrics.size(); ++m) {
      const std::vector<double>& a = found[i].series.metrics[m].values;
      const std::vector<double>& b = alone.series.metrics[m].values;
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return x == y || (std::isnan(x) && std::isnan(y));
      })) << name(alone.series.metrics[m].metric);
    }
  }
}

TEST(RecordedModes, TellStatesSlerpsTargetsAndSaturatedJoints) {
  ControlOutput control;
  control.state = ControlState::kFollowPlan;
  control.torque = control.commanded = JointVector::Zero(6);
  const JointVector zero = JointVector::Zero(6);
  Observation o;
  o.q = o.qd = &zero;
  o.control = &control;
  EXPECT_EQ(mode_of(o), static_cast<PeriodMode>(ControlState::kFollowPlan));
  const auto differs = [&o](const auto& change) {
    ControlOutput changed = *o.control;
    Observation other = o;
    other.control = &changed;
    change(changed, other);
    return mode_of(other) ^ mode_of(o);
  };
  EXPECT_EQ(differs([](ControlOutput& c, Observation&) { c.slerping = true; }), kModeSlerping);
  EXPECT_EQ(differs([](ControlOutput& c, Observation&) { c.damped = true; }), kModeDamped);
  EXPECT_EQ(differs([](ControlOutput& c, Observation&) { c.pace = 0.5; }), kModeSlowed);
  EXPECT_EQ(differs([](ControlOutput& c, Observation&) { c.commanded[2] = 1.0; }),
            PeriodMode{1} << (kFirstSaturatedBit + 2));
  EXPECT_EQ(differs([](ControlOutput&, Observation& other) { other.target = 5; }),
            PeriodMode{5} << kFirstTargetBit);
  EXPECT_NE(
      differs([](ControlOutput& c, Observation&) { c.state = ControlState::kFollowTrajectory; }) & kModeState,
      0U);
}

}  // namespace series_recorder_test
}  // namespace armtune::internal
