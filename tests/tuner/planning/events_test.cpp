#include "tuner/planning/yardstick/events.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/csv/cell.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/tuner/support/events.hpp"

namespace armtune::internal {
namespace events_test {

using test::of_kind;

constexpr double kLeaving = 0.0;
constexpr double kFollow = 2.0;
constexpr double kReturning = 1.0;
constexpr double kAvoiding = 3.0;

/// A rollout of the scenario in which the arm stands still on the path's start, with the states and gaze
/// angles given, a row every 0.1 s.
CsvTable table_of(const Scenario& scenario, const std::vector<double>& state,
                  const std::vector<double>& gaze) {
  std::string text = "time,state,gaze/angle,tool/position/x,tool/position/y,tool/position/z";
  for (const std::string& joint : joint_names(*scenario.robot))
    text += ",joint/" + joint + "/position,joint/" + joint + "/velocity";
  text += "\n";
  for (std::size_t k = 0; k < state.size(); ++k) {
    const double t = 0.1 * static_cast<double>(k);
    const Vec3 p = scenario.path.at(t).position + Vec3(0.002, 0.0, 0.0);
    text += cell(t) + "," + cell(state[k]) + "," + cell(gaze[k]);
    for (int i = 0; i < 3; ++i) text += "," + cell(p[i]);
    for (int i = 0; i < scenario.robot->n(); ++i) text += "," + cell(0.1 * i) + ",0.5";
    text += "\n";
  }
  return CsvTable::parse(text, "rollout.csv");
}

TEST(Events, ASwitchIsReachedWhenTheGazeIsUnderItsThresholdForGood) {
  const Scenario scenario = load_scenario("target_switch");  // every 8 s
  std::vector<double> state(200, kFollow);
  std::vector<double> gaze(200, 0.01);
  for (std::size_t k = 80; k < 95; ++k) gaze[k] = 0.5;
  gaze[97] = 0.2;  // once more outside
  std::vector<Event> events = events_of(table_of(scenario, state, gaze), scenario, 0.15);
  std::erase_if(events, [](const Event& e) { return e.kind != EventKind::kSwitch; });
  ASSERT_EQ(events.size(), 2U);
  EXPECT_NEAR(events[0].time, 8.0, 1e-9);
  EXPECT_NEAR(events[0].reached, 1.8, 1e-9);
  EXPECT_NEAR(events[0].path_error, 0.002, 1e-9);
  EXPECT_NEAR(events[0].position[3], 0.3, 1e-12);
  EXPECT_NEAR(events[0].velocity[3], 0.5, 1e-12);
  EXPECT_EQ(events[1].reached, 0.0);

  gaze.assign(200, 0.5);
  events = events_of(table_of(scenario, state, gaze), scenario, 0.15);
  std::erase_if(events, [](const Event& e) { return e.kind != EventKind::kSwitch; });
  ASSERT_FALSE(events.empty());
  EXPECT_TRUE(std::isnan(events.front().reached));
}

TEST(Events, AReturnIsReachedWhenThePathIsFollowedAgainAndALapIsAWholeTurn) {
  const Scenario scenario = load_scenario("moving_target");  // a turn takes 10 s
  std::vector<double> state(260, kFollow);
  for (std::size_t k = 30; k < 42; ++k) state[k] = kReturning;
  const std::vector<double> gaze(260, 0.03);
  const std::vector<Event> events = events_of(table_of(scenario, state, gaze), scenario, 0.15);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].kind, EventKind::kReturn);
  EXPECT_NEAR(events[0].time, 3.0, 1e-9);
  EXPECT_NEAR(events[0].reached, 1.2, 1e-9);
  EXPECT_EQ(events[1].kind, EventKind::kLap);
  EXPECT_NEAR(events[1].time, 4.2, 1e-9);
  EXPECT_NEAR(events[1].end, 14.2, 1e-9);
  EXPECT_NEAR(events[1].reached, 0.03, 1e-12);
  EXPECT_NEAR(events[2].time, 14.2, 1e-9);
}

TEST(Events, ASwitchOnTheWayBackToThePathIsJudgedUntilTheNext) {
  const Scenario scenario = load_scenario("target_switch");  // every 8 s
  std::vector<double> state(200, kFollow);
  std::vector<double> gaze(200, 0.01);
  for (std::size_t k = 75; k < 90; ++k) state[k] = kReturning;
  for (std::size_t k = 80; k < 95; ++k) gaze[k] = 0.5;
  std::vector<Event> events =
      of_kind(events_of(table_of(scenario, state, gaze), scenario, 0.15), EventKind::kSwitch);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].state, ControlState::kReturnToTrajectory);
  EXPECT_EQ(events[0].outcome, EventOutcome::kReached);
  EXPECT_NEAR(events[0].reached, 1.5, 1e-9);
  EXPECT_EQ(events[0].settled, events[0].reached);

  // Before the path is first reached there is nothing to reacquire.
  for (std::size_t k = 0; k < 90; ++k) state[k] = kLeaving;
  events = of_kind(events_of(table_of(scenario, state, gaze), scenario, 0.15), EventKind::kSwitch);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events[0].time, 16.0, 1e-9);
}

TEST(Events, TheSlowestSwitchIsTheOneOfReacquisitionTime) {
  for (const char* name : {"target_switch", "obstacle_pass"}) {
    const Scenario scenario = load_scenario(name);
    for (const char* set : {"published", "extended_tuned"}) {
      const Gains gains = load_gains(set, joint_names(*scenario.robot));
      const std::vector<Event> events = of_kind(test::simulated(scenario, gains, 1), EventKind::kSwitch);
      const RolloutResult result = Rollout(scenario, Stepper::kMidpoint).run(gains);
      double slowest = NAN;
      for (const Event& event : events) slowest = std::fmax(slowest, event.settled);
      const double metric = result.metrics[Metric::kReacquisitionTime];
      EXPECT_EQ(std::isnan(slowest), std::isnan(metric)) << name << ", " << set;
      if (!std::isnan(metric)) {
        EXPECT_NEAR(slowest, metric, 1.01 * scenario.control_period) << name << ", " << set;
      }
    }
  }
}

TEST(Events, WhatCutsASwitchOffIsSaid) {
  const Scenario scenario = load_scenario("target_switch");  // every 8 s
  std::vector<double> state(300, kFollow);
  std::vector<double> gaze(300, 0.01);
  for (std::size_t k = 80; k < 120; ++k) gaze[k] = 0.5;
  for (std::size_t k = 100; k < 120; ++k) state[k] = kAvoiding;
  for (std::size_t k = 240; k < 300; ++k) gaze[k] = 0.5;
  auto switches = of_kind(events_of(table_of(scenario, state, gaze), scenario, 0.15), EventKind::kSwitch);
  ASSERT_EQ(switches.size(), 3U);
  EXPECT_EQ(switches[0].outcome, EventOutcome::kCutByState);
  EXPECT_NEAR(switches[0].end, 10.0, 1e-9);
  EXPECT_EQ(switches[1].outcome, EventOutcome::kAlreadyThere);
  EXPECT_EQ(switches[1].reached, 0.0);
  EXPECT_EQ(switches[2].outcome, EventOutcome::kCutByEnd);
  EXPECT_TRUE(std::isnan(switches[2].reached));

  gaze.assign(300, 0.5);
  state.assign(300, kFollow);
  switches = of_kind(events_of(table_of(scenario, state, gaze), scenario, 0.15), EventKind::kSwitch);
  ASSERT_EQ(switches.size(), 3U);
  EXPECT_EQ(switches[0].outcome, EventOutcome::kNotReached);
  EXPECT_NEAR(switches[0].end, 16.0, 1e-9);
}

TEST(Events, AReturnThatAnObstacleOrTheEndCutsOffIsNotReached) {
  const Scenario scenario = load_scenario("moving_target");
  std::vector<double> state(100, kFollow);
  for (std::size_t k = 30; k < 42; ++k) state[k] = kReturning;
  for (std::size_t k = 42; k < 50; ++k) state[k] = kAvoiding;
  for (std::size_t k = 50; k < 60; ++k) state[k] = kReturning;
  for (std::size_t k = 90; k < 100; ++k) state[k] = kReturning;
  const std::vector<double> gaze(100, 0.03);
  const auto returns =
      of_kind(events_of(table_of(scenario, state, gaze), scenario, 0.15), EventKind::kReturn);
  ASSERT_EQ(returns.size(), 3U);
  EXPECT_EQ(returns[0].outcome, EventOutcome::kCutByState);
  EXPECT_TRUE(std::isnan(returns[0].reached));
  EXPECT_EQ(returns[1].outcome, EventOutcome::kReached);
  EXPECT_NEAR(returns[1].reached, 1.0, 1e-9);
  EXPECT_EQ(returns[2].outcome, EventOutcome::kCutByEnd);
  EXPECT_TRUE(std::isnan(returns[2].reached));
}

TEST(Events, OfObstaclesTheLeastDistanceMeanwhileCounts) {
  Scenario scenario = load_scenario("obstacle_pass");
  scenario.duration = 20.0;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const CsvTable table = test::recording_of(scenario, gains, 5);
  const std::vector<Event> events =
      of_kind(events_of(table, scenario, gains.slerpAngularErrorThreshold), EventKind::kReturn);
  ASSERT_FALSE(events.empty());
  const std::vector<double> time = table.numbers(table.column("time"));
  Poses poses;
  JointVector q(scenario.robot->n());
  for (const Event& event : events) {
    double nearest = INFINITY;
    for (std::size_t row = 0; row < time.size(); ++row) {
      if (time[row] < event.time || time[row] >= event.end) continue;
      for (int i = 0; i < scenario.robot->n(); ++i) {
        const std::string joint = scenario.robot->joints[static_cast<std::size_t>(i)].name;
        q[i] = table.number(row, table.column("joint/" + joint + "/position"));
      }
      forward_kinematics(scenario.robot->chain, q, poses);
      for (const MovingObstacle& obstacle : scenario.obstacles) {
        const Vec3 center = obstacle.path.at(time[row]).position;
        nearest = std::min(nearest, (poses.p_0T - center).norm());
        for (std::size_t i = 1; i < scenario.robot->joints.size(); ++i)  // the first stands still
          nearest = std::min(nearest, (poses.p_0B[i] - center).norm());
      }
    }
    EXPECT_NEAR(event.nearest, nearest, 1e-12) << event.time;
  }
  EXPECT_EQ(of_kind(events_of(table_of(load_scenario("target_switch"), std::vector<double>(200, kFollow),
                                       std::vector<double>(200, 0.01)),
                              load_scenario("target_switch"), 0.15),
                    EventKind::kSwitch)
                .front()
                .nearest,
            INFINITY);
}

TEST(Events, DistanceFromThePathCountsAsLongAsASwitchsPlanLasts) {
  const Scenario scenario = load_scenario("target_switch");
  std::vector<double> gaze(200, 0.01);
  for (std::size_t k = 80; k < 90; ++k) gaze[k] = 0.5;  // reached after 1 s
  const auto error_with = [&](std::size_t far) {
    // The row `far` is 0.05 m from the path, in x.
    CsvTable plain = table_of(scenario, std::vector<double>(200, kFollow), gaze);
    std::string text;
    for (const std::string& column : plain.header()) text += (text.empty() ? "" : ",") + column;
    text += "\n";
    for (std::size_t r = 0; r < plain.rows(); ++r) {
      for (std::size_t c = 0; c < plain.header().size(); ++c) {
        const bool moved = r == far && plain.header()[c] == "tool/position/x";
        text += (c == 0 ? "" : ",") + cell(plain.number(r, c) + (moved ? 0.05 : 0.0));
      }
      text += "\n";
    }
    return of_kind(events_of(CsvTable::parse(text, "far.csv"), scenario, 0.15), EventKind::kSwitch)
        .front()
        .path_error;
  };
  EXPECT_NEAR(error_with(85), 0.052, 1e-9) << "on the way";
  EXPECT_NEAR(error_with(94), 0.052, 1e-9) << "while a plan would hold";
  EXPECT_NEAR(error_with(110), 0.002, 1e-9) << "long after: no plan's business";
}

}  // namespace events_test
}  // namespace armtune::internal
