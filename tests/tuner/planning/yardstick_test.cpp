#include "tuner/planning/yardstick/yardstick.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/control/obstacle_distance.hpp"
#include "core/trajectory/gaze.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/tuner/support/events.hpp"
#include "tuner/planning/tasks/given_states.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"

namespace armtune::internal {
namespace yardstick_test {

using test::of_kind;
using test::simulated;
using testing::HasSubstr;

TEST(Yardstick, NoControllerBeatsTheLimit) {
  Scenario scenario = load_scenario("target_switch");
  scenario.duration = 24.5;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  int held = 0;
  for (const Event& event : simulated(scenario, gains, 1)) {
    if (event.kind == EventKind::kLap) continue;
    const Measure found = measure(event, scenario, {}, {});
    EXPECT_LE(found.limit, event.reached + 0.002) << name(event.kind) << " at " << event.time;
    ++held;
    if (found.status == MeasureStatus::kThereAtOnce) continue;  // what leaveSingularity ends with
    ASSERT_EQ(found.status, MeasureStatus::kSolved) << name(event.kind) << " at " << event.time;
    EXPECT_GE(found.ratio(), 0.99);
  }
  EXPECT_GE(held, 3);  // two switches and a return
}

/// A lap's limit with the knots of its own, and with twice as many.
void expect_no_matter_of_knots(const char* name, double tolerance) {
  Scenario scenario = load_scenario(name);
  scenario.duration = 20.0;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const auto laps = of_kind(simulated(scenario, gains, 5), EventKind::kLap);
  ASSERT_EQ(laps.size(), 1U);
  YardstickOptions once, twice;
  once.knots = task_of(laps[0], scenario, {}).knots;
  EXPECT_GE(once.knots, 400) << "25 ms of its 10 s, whatever was asked for";
  twice.knots = 2 * once.knots;
  const Measure a = measure(laps[0], scenario, once, {});
  const Measure b = measure(laps[0], scenario, twice, {});
  ASSERT_EQ(a.status, MeasureStatus::kSolved);
  ASSERT_EQ(b.status, MeasureStatus::kSolved);
  EXPECT_NEAR(a.limit, b.limit, tolerance * laps[0].reached);
  EXPECT_LE(b.limit, laps[0].reached);
}

TEST(Yardstick, ALapsLimitIsNoMatterOfItsKnots) {
  // What the start leaves is gone after an interval or two, and their length is its share of the mean.
  expect_no_matter_of_knots("moving_target", 0.01);
  // A switch within the lap, which takes three intervals of 12.5 ms at the limits.
  expect_no_matter_of_knots("target_switch", 0.02);
}

TEST(Yardstick, ThePlansMeanIsOverTheRolloutsTimes) {
  const Scenario scenario = load_scenario("moving_target");
  const RobotModel robot = plant_model(scenario);
  // At rest for a second on 2 and on 9 knots: another grid, the same motion.
  const auto at_rest = [&](int knots) {
    Trajectory t;
    t.durations = {1.0};
    t.position = scenario.start_position.replicate(1, knots);
    t.velocity = t.acceleration = Eigen::MatrixXd::Zero(robot.n(), knots);
    for (int k = 0; k < knots; ++k) t.time.push_back(static_cast<double>(k) / (knots - 1));
    return t;
  };
  const std::vector<double> times = {0.0, 0.1, 0.35, 0.9};
  Poses poses;
  forward_kinematics(robot.chain, scenario.start_position, poses);
  double sum = 0.0;
  for (const double t : times) {
    const Vec3 line = (scenario.targets[0].path.at(t).position - poses.p_0T).normalized();
    sum += std::pow(std::acos(line.dot(poses.R_0T.col(2))), 2);
  }
  EXPECT_NEAR(gaze_rms(scenario, robot, at_rest(2), times), std::sqrt(sum / 4.0), 1e-9);
  EXPECT_NEAR(gaze_rms(scenario, robot, at_rest(9), times), std::sqrt(sum / 4.0), 1e-9);
}

TEST(Yardstick, WhatIsOnTargetToBeginWithNeedsNoPlanAndHasNoRatio) {
  Event event;
  event.gaze = 0.1;
  event.outcome = EventOutcome::kAlreadyThere;
  const Scenario scenario = load_scenario("target_switch");
  Measure found = measure(event, scenario, {}, {});
  EXPECT_EQ(found.status, MeasureStatus::kThereAtOnce);
  EXPECT_EQ(found.limit, 0.0);
  EXPECT_TRUE(std::isnan(found.ratio()));
  EXPECT_THAT(yardstick_csv({found}),
              HasSubstr(",0,followTrajectory,0,0,,s,already there,,,there at once\n"));
  event.reached = 1.8;  // it went off target once more
  event.outcome = EventOutcome::kReached;
  found = measure(event, scenario, {}, {});
  EXPECT_EQ(found.limit, 0.0);
  EXPECT_TRUE(std::isnan(found.ratio()));
}

TEST(Yardstick, AReturnThatIsOnThePathToBeginWithIsThereAtOnce) {
  Scenario scenario = load_scenario("moving_target");
  const RobotModel robot = plant_model(scenario);
  Event event;
  event.kind = EventKind::kReturn;
  event.reached = 0.05;
  event.position.resize(6);
  event.position << 0.35, -1.4, -1.9, -1.4, 1.57, 0.0;
  event.velocity = JointVector::Zero(6);
  // A path that rests where the tool is.
  Poses poses;
  forward_kinematics(robot.chain, event.position, poses);
  scenario.path.center = poses.p_0T;
  scenario.path.frequency = 0.0;
  scenario.path.terms.clear();
  const Measure found = measure(event, scenario, {}, {});
  EXPECT_EQ(found.status, MeasureStatus::kThereAtOnce);
  EXPECT_EQ(found.limit, 0.0);
  EXPECT_TRUE(std::isnan(found.ratio()));
  EXPECT_EQ(found.held_back_by, "");
}

TEST(Yardstick, ASwitchsPlanStaysOnTargetNoLongerThanTheControllerStillWas) {
  const Scenario scenario = load_scenario("target_switch");
  Event event;
  event.position = scenario.start_position;
  event.velocity = JointVector::Zero(scenario.robot->n());
  event.time = 8.0;
  event.end = 16.0;
  event.gaze = 1.0;
  event.reached = 1.2;
  EXPECT_EQ(task_of(event, scenario, {}).hold, kSwitchHold);
  event.reached = 7.7;
  EXPECT_NEAR(task_of(event, scenario, {}).hold, 0.3, 1e-9);
  event.reached = 7.999;
  EXPECT_GT(task_of(event, scenario, {}).hold, 0.0);
}

TEST(Yardstick, ALimitBeyondTheNextSwitchIsCalledThat) {
  Scenario scenario = load_scenario("target_switch");
  scenario.duration = 17.5;  // follows its path from 8.05 s on, between its two switches
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const auto switches = of_kind(simulated(scenario, gains, 5), EventKind::kSwitch);
  ASSERT_EQ(switches.size(), 2U);
  EXPECT_EQ(switches[0].state, ControlState::kReturnToTrajectory);
  const Measure found = measure(switches[1], scenario, {}, {});
  ASSERT_EQ(found.status, MeasureStatus::kSolved);
  // The same state and targets, but they switch again sooner than anybody gets there.
  Scenario hasty = scenario;
  hasty.switch_every = 8.0 / std::ceil(8.0 / (0.5 * found.limit));  // an even number until 16 s
  ASSERT_LT(hasty.switch_every, found.limit);
  EXPECT_EQ(measure(switches[1], hasty, {}, {}).status, MeasureStatus::kPastNextSwitch);
}

TEST(Yardstick, AToolThatIsNearestToAnObstacleLeavesRoomForAPlan) {
  Scenario scenario = load_scenario("obstacle_pass");
  const RobotModel robot = plant_model(scenario);
  Event event;
  event.kind = EventKind::kReturn;
  event.position = scenario.start_position;
  event.velocity = JointVector::Zero(robot.n());
  Poses poses;
  forward_kinematics(robot.chain, event.position, poses);
  Path before_the_tool;
  before_the_tool.center = poses.p_0T + 0.2 * poses.R_0T.col(2);
  scenario.obstacles = {{"before the tool", before_the_tool}};
  const std::vector<Obstacle> obstacles{scenario.obstacles[0].at(0.0)};
  ASSERT_GT(obstacle_distance(robot.chain, poses, obstacles), 0.21) << "no joint is as near";
  event.nearest = clearance_at(robot, event.position, event.time, scenario.obstacles);
  YardstickOptions options;
  options.clearance = 0.205;
  const PlanTask task = task_of(event, scenario, options);
  EXPECT_NEAR(task.clearance, 0.2, 1e-5);
  EXPECT_NO_THROW(plan_problem(task));
}

TEST(Yardstick, PlansKeepClearOfObstaclesAsFarAsTheControllerDid) {
  Scenario scenario = load_scenario("obstacle_pass");
  scenario.duration = 30.0;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  YardstickOptions clear;
  clear.clearance = gains.obstacleInfluenceRadius;
  int kept = 0;
  for (const Event& event : of_kind(simulated(scenario, gains, 5), EventKind::kReturn)) {
    const PlanTask task = task_of(event, scenario, clear);
    EXPECT_GT(task.clearance, 0.0);
    EXPECT_LE(task.clearance, clear.clearance);
    EXPECT_LE(task.clearance, event.nearest);
    EXPECT_GE(task.clearance, std::min(clear.clearance, event.nearest) - 1e-5);
    const Measure with = measure(event, scenario, clear, {});
    const Measure without = measure(event, scenario, {}, {});
    if (without.status == MeasureStatus::kThereAtOnce) continue;
    ASSERT_EQ(without.status, MeasureStatus::kSolved) << event.time;
    EXPECT_TRUE(std::isnan(without.clearance));
    if (with.status != MeasureStatus::kSolved) {
      EXPECT_EQ(with.status, MeasureStatus::kWithoutClearance);
      EXPECT_TRUE(std::isnan(with.clearance));
      continue;
    }
    EXPECT_EQ(with.clearance, task.clearance);
    // The controller kept the same limits, and as clear.
    if (event.outcome == EventOutcome::kReached) {
      EXPECT_GE(with.ratio(), 1.0) << event.time;
    }
    // A limit more can only cost time, but for what another local optimum and the tolerances leave.
    EXPECT_GE(with.limit, without.limit * (1.0 - 1e-3)) << event.time;
    ++kept;
  }
  EXPECT_GE(kept, 1);
}

TEST(Yardstick, OfAScenariosSwitchesTheSlowestOnesLimitCounts) {
  const auto with = [](const char* scenario, EventKind kind, double settled, double limit) {
    Measure m;
    m.scenario = scenario;
    m.event.kind = kind;
    m.event.settled = settled;
    m.limit = limit;
    return m;
  };
  const std::vector<Measure> measures = {
      with("a", EventKind::kSwitch, 1.5, 0.7), with("a", EventKind::kSwitch, 2.0, 0.5),
      with("a", EventKind::kReturn, 3.0, 3.0), with("b", EventKind::kSwitch, 1.0, 0.5),
      with("b", EventKind::kSwitch, 8.0, NAN), with("c", EventKind::kLap, 0.0, 0.1)};
  EXPECT_EQ(reacquisition_limit(measures, "a"), 0.5);
  EXPECT_TRUE(std::isnan(reacquisition_limit(measures, "b"))) << "another switch's limit is none of it";
  EXPECT_TRUE(std::isnan(reacquisition_limit(measures, "c")));
}

}  // namespace yardstick_test
}  // namespace armtune::internal
