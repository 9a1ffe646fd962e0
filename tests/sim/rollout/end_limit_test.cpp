#include "sim/rollout/end_limit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/planned.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace end_limit_test {

using test::bits;
using test::quick_gains;
using test::scenario_of;

RolloutResult run(const Scenario& scenario, const EndLimits& limits, const Observer& observer = {}) {
  return Rollout(scenario, Stepper::kMidpoint).run(quick_gains(scenario), observer, limits);
}

/// Longer and longer parts of a scenario; looked_at gains the metrics that had a value.
void expect_worse_and_worse(const Scenario& whole, std::set<Metric>& looked_at) {
  Metrics before;
  int grew = 0;
  for (const double share : {0.02, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    Scenario part = whole;
    part.duration = share * whole.duration;
    const Metrics now = run(part, {}).metrics;
    for (const Metric m : all_metrics()) {
      if (!std::isnan(now[m])) looked_at.insert(m);
      if (!only_worsens(m) || std::isnan(before[m])) continue;
      if (larger_is_better(m)) {
        EXPECT_LE(now[m], before[m]) << name(m);
      } else {
        EXPECT_GE(now[m], before[m]) << name(m);
      }
      if (now[m] != before[m]) ++grew;
    }
    before = now;
  }
  EXPECT_GT(grew, 0);
}

TEST(EndLimit, AMetricThatOnlyWorsensNeverGetsBetterInALongerRollout) {
  std::set<Metric> looked_at;
  Scenario obstacles = scenario_of("obstacle_pass");
  Cell cell;
  cell.floor = -0.5;
  cell.parts.push_back(
      {"post", capsule(0.05, 1.0), Mat3::Identity(), Path{Vec3(1.5, 0.0, 0.5), 0.0, 0.0, {}}});
  obstacles.clearance = std::make_shared<const ClearanceModel>(obstacles.robot, cell);
  expect_worse_and_worse(obstacles, looked_at);
  // Joint errors are those of plans only.
  const test::TemporaryFolder folder;
  // Accelerations are compared with limits where the robot file has them.
  folder.write(
      "arm.yaml",
      "urdf: " + test::source_dir() +
          "/sim/robots/ur10.urdf\ntip_link: tool0\nrotor_inertia: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\nlimits: {elbow_joint: {acceleration: 5}}\n");
  expect_worse_and_worse(
      load_scenario(folder.write("limited.yaml", "base: moving_target\nrobot: arm.yaml\nduration: 2\n")),
      looked_at);
  test::QuinticPlan plan;
  plan.start = obstacles.start_position;
  plan.goal = obstacles.start_position + JointVector::Constant(6, 0.3);
  folder.write("plan.csv", test::plan_csv(*obstacles.robot, plan));
  expect_worse_and_worse(load_scenario(folder.write(
                             "follow.yaml", "base: moving_target\nplanned: plan.csv\nduration: planned\n")),
                         looked_at);
  for (const Metric m : all_metrics()) {
    EXPECT_TRUE(!only_worsens(m) || looked_at.contains(m)) << name(m) << " was never looked at";
  }
}

TEST(EndLimit, EndsTheRolloutInTheFirstPeriodThatReachesIt) {
  const Scenario scenario = scenario_of("moving_target", 6.0);
  const double largest = run(scenario, {}).metrics[Metric::kJointVelocityMaxRatio];
  const double limit = 0.7 * largest;
  // When it has to end, by the definition of the ratio.
  double first = -1.0;
  run(scenario, {}, [&](const Observation& o) {
    const JointVector limits = scenario.robot->velocity_limits();
    if (first < 0.0 && o.qd->cwiseQuotient(limits).lpNorm<Eigen::Infinity>() >= limit) first = o.time;
    return true;
  });
  const RolloutResult ended = run(scenario, {{Metric::kJointVelocityMaxRatio, limit}});
  EXPECT_EQ(ended.status, RolloutStatus::kHopeless);
  EXPECT_STREQ(name(ended.status), "hopeless");
  EXPECT_GT(first, 0.0);
  EXPECT_DOUBLE_EQ(ended.end_time, first);
  EXPECT_THAT(ended.reason, testing::MatchesRegex("joint_velocity/max_ratio reached [0-9.]+ at [0-9.]+ s in "
                                                  "the state [a-zA-Z]+; .* this metric reaches [0-9.]+"));
  // Up to there it is the rollout that has no limit.
  const RolloutResult cut = run(scenario, {}, [&](const Observation& o) { return o.time < first; });
  EXPECT_EQ(cut.status, RolloutStatus::kInterrupted);
  EXPECT_EQ(bits(ended.metrics), bits(cut.metrics));
}

TEST(EndLimit, OfALowerBoundIsReachedFromAbove) {
  const Scenario scenario = scenario_of("moving_target", 6.0);
  const double least = run(scenario, {}).metrics[Metric::kJointPositionMinMargin];
  const double at_start = run(scenario_of("moving_target", 0.1), {}).metrics[Metric::kJointPositionMinMargin];
  ASSERT_LT(least, at_start);
  const double limit = 0.5 * (least + at_start);
  const RolloutResult ended = run(scenario, {{Metric::kJointPositionMinMargin, limit}});
  EXPECT_EQ(ended.status, RolloutStatus::kHopeless);
  EXPECT_LE(ended.metrics[Metric::kJointPositionMinMargin], limit);
  EXPECT_GT(ended.end_time, 0.1);
  EXPECT_LT(ended.end_time, scenario.duration);
}

TEST(EndLimit, ThatIsNeverReachedChangesNothing) {
  const Scenario scenario = scenario_of("moving_target", 6.0);
  const RolloutResult whole = run(scenario, {});
  EndLimits limits = {{Metric::kObstacleMinClearance, 1e9}};  // has no value without obstacles
  for (const Metric m :
       {Metric::kJointVelocityMaxRatio, Metric::kJointEffortMaxRatio, Metric::kOrientationMax}) {
    limits.push_back({m, 1.001 * whole.metrics[m]});
  }
  limits.push_back({Metric::kJointPositionMinMargin, whole.metrics[Metric::kJointPositionMinMargin] - 0.001});
  const RolloutResult limited = run(scenario, limits);
  EXPECT_EQ(limited.status, RolloutStatus::kCompleted) << limited.reason;
  EXPECT_EQ(limited.end_time, scenario.duration);
  EXPECT_EQ(bits(limited.metrics), bits(whole.metrics));
}

}  // namespace end_limit_test
}  // namespace armtune::internal
