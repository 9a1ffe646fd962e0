#include "sim/rollout/end_cost.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/rollouts.hpp"

namespace armtune {
namespace {

using test::bits;
using test::quick_gains;
using test::scenario_of;

RolloutResult run(const Scenario& scenario, const EndCost& cost, const Observer& observer = {}) {
  return Rollout(scenario, Stepper::kMidpoint).run(quick_gains(scenario), observer, {}, cost);
}

TEST(EndCost, AShareGrowsFromItsBoundToItsMost) {
  const EndCost::Share upper{Metric::kJointVelocityMaxRatio, 0.9, 2.0, 3.0};
  EXPECT_EQ(upper.at(0.5), 0.0);
  EXPECT_NEAR(upper.at(1.4), 1.0, 1e-15);
  EXPECT_EQ(upper.at(100.0), 3.0);
  EXPECT_EQ(upper.at(HUGE_VAL), 0.0) << "what that costs in the end is less than most";
  EXPECT_EQ(upper.at(NAN), 0.0);
  const EndCost::Share lower{Metric::kJointPositionMinMargin, 0.2, -5.0, 3.0};
  EXPECT_EQ(lower.at(0.3), 0.0);
  EXPECT_NEAR(lower.at(0.1), 0.5, 1e-15);
}

/// Half of what the velocities cost beyond half of their largest, and what margins below 3 rad do.
EndCost cost_of(const RolloutResult& whole, double beyond) {
  EndCost cost;
  cost.shares = {{Metric::kJointVelocityMaxRatio, 0.5 * whole.metrics[Metric::kJointVelocityMaxRatio], 0.5},
                 {Metric::kJointPositionMinMargin, 3.0, -0.01},
                 {Metric::kObstacleMinClearance, 1e9, -1.0}};  // has no value without obstacles
  cost.beyond = beyond;
  return cost;
}

double sum_at(const EndCost& cost, double ratio, double margin) {
  return cost.shares[0].at(ratio) + cost.shares[1].at(margin);
}

TEST(EndCost, EndsTheRolloutInTheFirstPeriodInWhichTheSumIsAboveIt) {
  const Scenario scenario = scenario_of("moving_target", 6.0);
  const RolloutResult whole = run(scenario, {});
  EndCost cost = cost_of(whole, 0.0);
  cost.beyond = 0.8 * sum_at(cost, whole.metrics[Metric::kJointVelocityMaxRatio],
                             whole.metrics[Metric::kJointPositionMinMargin]);
  // When it has to end, by the definitions of the two metrics.
  double first = -1.0;
  double ratio = 0.0;
  double margin = HUGE_VAL;
  run(scenario, {}, [&](const Observation& o) {
    for (int i = 0; i < scenario.robot->n(); ++i) {
      const JointLimits& limits = scenario.robot->joints[static_cast<std::size_t>(i)].limits;
      ratio = std::max(ratio, std::abs((*o.qd)[i]) / limits.velocity);
      margin = std::min({margin, (*o.q)[i] - limits.lower, limits.upper - (*o.q)[i]});
    }
    if (first < 0.0 && sum_at(cost, ratio, margin) > cost.beyond) first = o.time;
    return true;
  });
  const RolloutResult ended = run(scenario, cost);
  EXPECT_EQ(ended.status, RolloutStatus::kOutdone);
  EXPECT_STREQ(name(ended.status), "outdone");
  EXPECT_GT(first, 0.0);
  EXPECT_DOUBLE_EQ(ended.end_time, first);
  EXPECT_THAT(ended.reason, testing::MatchesRegex("objective and penalties reached [0-9.]+ at [0-9.]+ s in "
                                                  "[a-zA-Z]+; of no use to the search from [0-9.]+ on"));
  const RolloutResult cut = run(scenario, {}, [&](const Observation& o) { return o.time < first; });
  EXPECT_EQ(bits(ended.metrics), bits(cut.metrics)) << "up to there it is the whole one";
}

TEST(EndCost, ThatIsNeverReachedChangesNothing) {
  const Scenario scenario = scenario_of("moving_target", 6.0);
  const RolloutResult whole = run(scenario, {});
  EndCost cost = cost_of(whole, 0.0);
  cost.beyond = sum_at(cost, whole.metrics[Metric::kJointVelocityMaxRatio],
                       whole.metrics[Metric::kJointPositionMinMargin]);
  const RolloutResult same = run(scenario, cost);
  EXPECT_EQ(same.status, RolloutStatus::kCompleted) << same.reason;
  EXPECT_EQ(bits(same.metrics), bits(whole.metrics));
}

}  // namespace
}  // namespace armtune
