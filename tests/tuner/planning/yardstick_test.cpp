#include "tuner/planning/yardstick/yardstick.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/trajectory/gaze.hpp"
#include "sim/csv/cell.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"

namespace armtune {
namespace {

using testing::HasSubstr;

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

std::vector<Event> of_kind(std::vector<Event> events, EventKind kind) {
  std::erase_if(events, [kind](const Event& e) { return e.kind != kind; });
  return events;
}

/// Events of a rollout of the scenario, a row every `stride` periods.
std::vector<Event> simulated(const Scenario& scenario, const Gains& gains, int stride) {
  const test::TemporaryFolder folder;
  Recorder recorder(scenario, stride);
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&](const Observation& o) { return recorder(o); });
  recorder.write_csv(folder / "rollout.csv");
  return events_of(CsvTable::read(folder / "rollout.csv"), scenario, gains.slerpAngularErrorThreshold);
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
  EXPECT_THAT(yardstick_csv({found}), HasSubstr(",0,0,0,,s,already there,,,there at once\n"));
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
  scenario.duration = 17.5;  // follows its path from 8.05 s on: the second switch, at 16 s
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const auto switches = of_kind(simulated(scenario, gains, 5), EventKind::kSwitch);
  ASSERT_EQ(switches.size(), 1U);
  const Measure found = measure(switches[0], scenario, {}, {});
  ASSERT_EQ(found.status, MeasureStatus::kSolved);
  // The same state and targets, but they switch again sooner than anybody gets there.
  Scenario hasty = scenario;
  hasty.switch_every = 8.0 / std::ceil(8.0 / (0.5 * found.limit));  // an even number until 16 s
  ASSERT_LT(hasty.switch_every, found.limit);
  EXPECT_EQ(measure(switches[0], hasty, {}, {}).status, MeasureStatus::kPastNextSwitch);
}

TEST(Yardstick, PlansKeepClearOfObstaclesAsFarAsTheArmIsWhenItBegins) {
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
    // A limit more can only cost time, but for what another local optimum and the tolerances leave.
    EXPECT_GE(with.limit, without.limit * (1.0 - 1e-3)) << event.time;
    ++kept;
  }
  EXPECT_GE(kept, 1);
}

TEST(Yardstick, OfAScenariosSwitchesTheLargestLimitCounts) {
  const auto with = [](const char* scenario, EventKind kind, double limit) {
    Measure m;
    m.scenario = scenario;
    m.event.kind = kind;
    m.limit = limit;
    return m;
  };
  const std::vector<Measure> measures = {
      with("a", EventKind::kSwitch, 0.5), with("a", EventKind::kSwitch, NAN),
      with("a", EventKind::kSwitch, 0.7), with("a", EventKind::kReturn, 3.0),
      with("b", EventKind::kSwitch, 9.0), with("c", EventKind::kLap, 0.1)};
  EXPECT_EQ(reacquisition_limit(measures, "a"), 0.7);
  EXPECT_EQ(reacquisition_limit(measures, "b"), 9.0);
  EXPECT_TRUE(std::isnan(reacquisition_limit(measures, "c")));
}

TEST(Yardstick, WritesARowAnEventAndLeavesEmptyWhatThereIsNot) {
  Measure solved;
  solved.scenario = "s";
  solved.event.time = 8.0;
  solved.event.reached = 1.5;
  solved.limit = 0.5;
  solved.clearance = 0.325;
  solved.status = MeasureStatus::kSolved;
  solved.held_back_by = "velocity of elbow_joint";
  Measure infeasible = solved;
  infeasible.status = MeasureStatus::kInfeasible;
  infeasible.limit = infeasible.clearance = NAN;
  infeasible.scenario = "with, comma";
  Measure missed = solved;
  missed.event.outcome = EventOutcome::kNotReached;
  missed.event.reached = NAN;
  const std::string text = yardstick_csv({solved, infeasible, missed});
  EXPECT_THAT(text, HasSubstr("\ns,switch,8,1.5,0.5,3,s,reached,velocity of elbow_joint,0.325,solved\n"));
  EXPECT_THAT(text, HasSubstr("\n\"with, comma\",switch,8,1.5,,,s,reached,velocity of "
                              "elbow_joint,,infeasible\n"));
  EXPECT_THAT(text, HasSubstr("\ns,switch,8,,0.5,,s,not before the next switch,velocity of "
                              "elbow_joint,0.325,solved\n"));
  // Every column is declared, and no row has another number of them.
  const auto table = CsvTable::parse(text, "yardstick.csv");
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.header().size(), yardstick_columns().size());
}

}  // namespace
}  // namespace armtune
