#include "tuner/endurance/endurance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/planned.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/endurance/error_windows.hpp"

namespace armtune::internal {
namespace endurance_test {

const std::atomic<bool> kNever{false};

std::vector<EnduranceResult> endured(const Scenario& scenario, const Gains& gains, double minutes,
                                     int workers = 1) {
  EnduranceOptions options;
  options.minutes = minutes;
  options.workers = workers;
  return endure(
      {scenario}, [&gains](const Scenario&) { return gains; }, options, kNever);
}

TEST(Endurance, ExtendsAScenarioAndShortensNone) {
  const Scenario scenario = test::scenario_of("moving_target");
  EXPECT_EQ(extended_to(scenario, 1800.0).duration, 1800.0);
  EXPECT_EQ(extended_to(scenario, 1.0).duration, scenario.duration);
}

TEST(ErrorWindows, AreOfEqualLengthAndDoNotMeet) {
  for (const double duration : {40.0, 600.0, 1800.0, 7200.0}) {
    const auto windows = compared_windows(duration);
    EXPECT_DOUBLE_EQ(windows[0].to - windows[0].from, windows[1].to - windows[1].from);
    EXPECT_LE(windows[0].to, windows[1].from + 1e-9);
    EXPECT_DOUBLE_EQ(windows[1].to, duration);
    EXPECT_GT(windows[0].from, 0.0);
  }
  const auto long_run = compared_windows(7200.0);
  EXPECT_EQ(long_run[0].from, 60.0);
  EXPECT_EQ(long_run[0].to, 660.0);
  EXPECT_EQ(long_run[1].from, 6600.0);
}

/// A jump to another target counts for a second neither in the first window nor in the last.
TEST(ErrorWindows, LeaveOutTheSecondAfterAChangeOfTheTarget) {
  ErrorWindows windows(0.0, 100.0, 0.01);
  ControlOutput control;
  control.state = ControlState::kFollowTrajectory;
  Observation o;
  o.control = &control;
  for (int k = 0; k < 10000; ++k) {
    o.time = 0.01 * k;
    o.target = k < 9000 ? 0U : 1U;
    const bool jump = k >= 9000 && k < 9090;
    o.error.setConstant(jump ? 1.0 : 1e-3);
    windows.look(o);
  }
  EXPECT_DOUBLE_EQ(windows.peak_growth(), 1.0);
  EXPECT_NEAR(windows.rms_growth(), 1.0, 1e-12);
  for (int k = 0; k < 200; ++k) {  // later than that it is an error
    o.time = 98.0 + 0.01 * k;
    o.error.setConstant(2e-3);
    windows.look(o);
  }
  EXPECT_DOUBLE_EQ(windows.peak_growth(), 2.0);
}

/// An adaptation that learns from noise fails; the same gains with the bounds hold. The adaptation gain is
/// so large that minutes show what takes a quarter of an hour otherwise.
TEST(Endurance, SeesParameterDriftAndTheBoundsPreventIt) {
  const Scenario scenario = test::scenario_of("identified_realistic_moving_target");
  Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  gains.adaptation_gain = 0.92;
  const auto bounded = endured(scenario, gains, 5.0);
  ASSERT_EQ(bounded.size(), 1U);
  EXPECT_TRUE(bounded[0].held()) << (bounded[0].broken ? to_string(*bounded[0].broken) : bounded[0].ended);
  EXPECT_EQ(bounded[0].engine, Engine::kNative);
  EXPECT_DOUBLE_EQ(bounded[0].simulated, 300.0);
  gains.adaptation_filter = 0.0;
  gains.adaptation_leakage = 0.0;
  gains.adaptation_inertia_leakage = 0.0;
  const auto drifting = endured(scenario, gains, 5.0);
  ASSERT_TRUE(drifting[0].broken);
  EXPECT_EQ(drifting[0].engine, Engine::kSimbody) << "what fails is confirmed there";
  EXPECT_EQ(drifting[0].broken->limit, JointLimit::kEffort);
  EXPECT_GT(drifting[0].broken->time, scenario.duration / 4) << "and not at once";
}

TEST(Endurance, AShareOfTheLimitsBreaksWhereTheMetricsReachIt) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 20.0);
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const Metrics reached = Rollout(scenario, Stepper::kMidpoint, Engine::kSimbody).run(gains).metrics;
  const double share =
      std::max(reached[Metric::kJointVelocityMaxRatio], reached[Metric::kJointEffortMaxRatio]);
  ASSERT_LT(share, 1.0);
  EnduranceOptions options;
  options.minutes = 1e-3;  // the scenario's own duration
  const auto with = [&](double limit_share) {
    options.limit_share = limit_share;
    return endure(
        {scenario}, [&gains](const Scenario&) { return gains; }, options, kNever)[0];
  };
  const EnduranceResult kept = with(1.001 * share);
  EXPECT_TRUE(kept.held()) << (kept.broken ? to_string(*kept.broken) : kept.ended);
  const EnduranceResult broken = with(0.999 * share);
  ASSERT_TRUE(broken.broken);
  EXPECT_EQ(broken.broken->share, 0.999 * share);
  EXPECT_EQ(broken.broken->limit,
            reached[Metric::kJointVelocityMaxRatio] == share ? JointLimit::kVelocity : JointLimit::kEffort);
}

/// Without roll control the last joint winds up until it passes its limit; with it, it does not.
TEST(Endurance, SeesWindingAndTheRollControlPreventsIt) {
  const Scenario scenario = test::scenario_of("identified_realistic_moving_target");
  Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  ASSERT_GT(gains.roll_centering_gain, 0.0);
  EXPECT_TRUE(endured(scenario, gains, 5.0)[0].held());
  gains.roll_centering_gain = 0.0;
  const auto winding = endured(scenario, gains, 5.0);
  ASSERT_TRUE(winding[0].broken);
  EXPECT_EQ(winding[0].broken->limit, JointLimit::kPosition);
  EXPECT_EQ(winding[0].broken->joint, scenario.robot->joints.back().name);
}

/// An integral that was filled by turns to the target must not roll the tool as the tool turns on: on this
/// arm, whose theta starts far off, that wound the last joint up in 138 s in spite of the roll control.
TEST(Endurance, TheIntegralDoesNotWindTheLastJointUp) {
  const Scenario model = test::scenario_of("realistic_moving_target");
  Scenario scenario = perturbed(model, default_perturbation({&model, 1}), 7, 4);
  scenario.duration = 180.0;
  Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  gains.task_space_gains_i.tail<3>() << 40.0, 40.0, 22.0;
  double farthest = 0.0;
  const auto watch = [&farthest](const Observation& o) {
    farthest = std::max(farthest, std::abs((*o.q)[5]));
    return true;
  };
  Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, watch);
  EXPECT_LT(farthest, 2.5);  // rad, of the 6.28 that it has
}

TEST(Endurance, IsTheSameForAnyNumberOfWorkers) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  const auto one = endured(scenario, gains, 6.0, 1);
  const auto two = endured(scenario, gains, 6.0, 2);
  EXPECT_EQ(one[0].rms_growth, two[0].rms_growth);
  EXPECT_EQ(one[0].peak_growth, two[0].peak_growth);
  EXPECT_EQ(one[0].broken.has_value(), two[0].broken.has_value());
}

TEST(Endurance, AsksOnlyRunsOfFiveMinutesWhetherTheirErrorsGrow) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  EXPECT_TRUE(std::isnan(endured(scenario, gains, 4.9)[0].rms_growth));
  EXPECT_GT(endured(scenario, gains, 5.0)[0].rms_growth, 0.0);
}

TEST(Endurance, SaysHowAStepGoesOn) {
  EXPECT_TRUE(how_extended(test::scenario_of("moving_target")).empty());
  EXPECT_EQ(how_extended(test::scenario_of("step_position")).size(), 1U);
  EXPECT_EQ(how_extended(test::scenario_of("sines_position")).size(), 1U);
}

/// Waypoints that loop repeat, so that nothing is to be said of them; others are held.
TEST(Endurance, SaysThatWaypointsAreHeldOnlyWhereTheyDoNotLoop) {
  const MotionPoint<Vec3> here{Vec3(0.5, 0.0, 0.5), Vec3::Zero(), Vec3::Zero()};
  const MotionPoint<Vec3> there{Vec3(0.5, 0.2, 0.5), Vec3::Zero(), Vec3::Zero()};
  Scenario scenario = test::scenario_of("moving_target");
  for (const bool loops : {false, true}) {
    scenario.path.spline = std::make_shared<const PositionSpline>(
        std::vector<double>{0.0, 1.0, 2.0}, std::vector<MotionPoint<Vec3>>{here, there, here}, loops);
    EXPECT_EQ(how_extended(scenario).size(), loops ? 0U : 1U);
  }
}

/// A planned motion that fills its scenario is followed by the task, and the sentence says so.
TEST(Endurance, GoesOnWithTheTaskAfterAPlannedMotion) {
  Scenario base = test::scenario_of("moving_target");
  const Gains gains = test::quick_gains(base);
  const test::TemporaryFolder folder;
  test::QuinticPlan plan;
  plan.start = base.start_position;
  plan.goal = gains.joint_space_goal * M_PI / 180.0;
  folder.write("plan.csv", test::plan_csv(*base.robot, plan));
  const Scenario scenario = load_scenario(folder.write(
      "own.yaml",
      "base: moving_target\nplanned: plan.csv\nduration: planned\ntheta_start: {model_scale: 1}\n"));
  ASSERT_FALSE(scenario.has_task());
  EXPECT_EQ(how_extended(scenario).size(), 1U);
  EXPECT_TRUE(how_extended(extended_to(scenario, 60.0)).empty()) << "its task is in it already";
  const auto results = endured(scenario, gains, 0.5);
  EXPECT_TRUE(results[0].ended.empty()) << results[0].ended;
  const RolloutResult longer =
      Rollout(extended_to(scenario, 30.0), Stepper::kMidpoint, Engine::kNative).run(gains);
  EXPECT_GT(longer.metrics[Metric::kSamples], 100.0) << "the task is tracked";
}

/// After a planned motion without any task, the joints stay where it ends.
TEST(Endurance, HoldsTheJointsAfterAPlannedMotionWithoutATask) {
  const Scenario base = test::scenario_of("moving_target");
  Gains gains = load_gains("extended_tuned", joint_names(*base.robot));
  const test::TemporaryFolder folder;
  test::QuinticPlan plan;
  plan.start = base.start_position;
  plan.goal = gains.joint_space_goal * M_PI / 180.0;
  folder.write("plan.csv", test::plan_csv(*base.robot, plan));
  const Scenario scenario = load_scenario(
      folder.write("own.yaml",
                   "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\nduration: planned\nseed: 1\n"
                   "theta_start: {model_scale: 1}\n"));
  ASSERT_FALSE(scenario.has_task());
  const auto sentences = how_extended(scenario);
  ASSERT_EQ(sentences.size(), 1U);
  const auto results = endured(scenario, gains, 0.5);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_TRUE(results[0].held()) << (results[0].broken ? to_string(*results[0].broken) : results[0].ended);
  EXPECT_DOUBLE_EQ(results[0].simulated, 30.0);
  EXPECT_TRUE(how_extended(extended_to(scenario, 60.0)).empty()) << "it stays there already";
  // The arm is where the motion ended, at rest.
  JointVector last, speed;
  Rollout(extended_to(scenario, 30.0), Stepper::kMidpoint, Engine::kNative)
      .run(gains, [&](const Observation& o) {
        last = *o.q;
        speed = *o.qd;
        return true;
      });
  EXPECT_LT((last - plan.goal).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT(speed.cwiseAbs().maxCoeff(), 0.01);
}

/// Twenty minutes of one bundled realistic scenario under its tuned gains: within every limit, and no error
/// grows.
TEST(Endurance, TheBundledTunedGainsHoldForTwentyMinutes) {
  const Scenario scenario = test::scenario_of("identified_realistic_target_switch");
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  const auto results = endured(scenario, gains, 20.0);
  EXPECT_TRUE(results[0].held()) << (results[0].broken ? to_string(*results[0].broken) : results[0].ended);
  EXPECT_LE(results[0].rms_growth, 1.2);
  EXPECT_LE(results[0].peak_growth, 1.5);
}

}  // namespace endurance_test
}  // namespace armtune::internal
