#include "tuner/planning/yardstick/yardstick.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/csv/cell.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune {
namespace {

using testing::HasSubstr;

constexpr double kFollow = 2.0;
constexpr double kReturning = 1.0;

/// A rollout of the scenario in which the arm stands still on the path's start, with the states and gaze
/// angles given, a row every 0.1 s.
report::CsvTable table_of(const Scenario& scenario, const std::vector<double>& state,
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
  return report::CsvTable::parse(text, "rollout.csv");
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

TEST(Yardstick, NoControllerBeatsTheLimit) {
  const test::TemporaryFolder folder;
  Scenario scenario = load_scenario("target_switch");
  scenario.duration = 24.5;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  Recorder recorder(scenario, 1);
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&](const Observation& o) { return recorder(o); });
  recorder.write_csv(folder / "rollout.csv");
  const std::vector<Event> events =
      events_of(report::CsvTable::read(folder / "rollout.csv"), scenario, gains.slerpAngularErrorThreshold);
  int held = 0;
  for (const Event& event : events) {
    if (event.kind == EventKind::kLap) continue;
    const Measure found = measure(event, scenario, {}, {});
    ASSERT_EQ(found.status, PlanStatus::kSolved) << name(event.kind) << " at " << event.time;
    EXPECT_LE(found.limit, event.reached + 0.002) << name(event.kind) << " at " << event.time;
    ++held;
  }
  EXPECT_GE(held, 3);  // two switches and a return
}

TEST(Yardstick, WritesARowAnEventAndLeavesEmptyWhatThereIsNot) {
  Measure solved;
  solved.scenario = "s";
  solved.event.time = 8.0;
  solved.event.reached = 1.5;
  solved.limit = 0.5;
  solved.status = PlanStatus::kSolved;
  solved.held_back_by = "velocity of elbow_joint";
  Measure infeasible = solved;
  infeasible.status = PlanStatus::kInfeasible;
  infeasible.limit = NAN;
  const std::string text = yardstick_csv({solved, infeasible});
  EXPECT_THAT(text, HasSubstr("\ns,switch,8,1.5,0.5,3,s,velocity of elbow_joint,solved\n"));
  EXPECT_THAT(text, HasSubstr("\ns,switch,8,1.5,,,s,velocity of elbow_joint,infeasible\n"));
}

}  // namespace
}  // namespace armtune
