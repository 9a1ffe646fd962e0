// Rollouts that begin with a planned trajectory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/rollout/applies.hpp"
#include "sim/rollout/recorder.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/planned.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace planned_rollout_test {

using enum ControlState;
using test::published_gains;

constexpr double kDegree = M_PI / 180.0;

/// A scenario of its own folder with a quintic between rest poses as its plan.
class PlannedRollout : public testing::Test {
 protected:
  PlannedRollout() {
    base_ = load_scenario("moving_target");
    plan_.start = base_.start_position;
    plan_.goal = published_gains(base_).joint_space_goal * kDegree;
  }
  Scenario scenario(const std::string& base = "moving_target",
                    const std::string& duration = "planned") const {
    folder_.write("plan.csv", test::plan_csv(*base_.robot, plan_));
    return load_scenario(folder_.write("own.yaml", "base: " + base + "\nplanned: plan.csv\nduration: " +
                                                       duration + "\ntheta_start: {model_scale: 1}\n"));
  }

  test::TemporaryFolder folder_;
  Scenario base_;
  test::QuinticPlan plan_;
};

TEST_F(PlannedRollout, BeginsOnThePlansOwnTimeWithItsPositionAndVelocity) {
  Scenario s = scenario();
  // From the plan's middle on.
  std::vector<double> time;
  std::vector<MotionPoint<JointVector>> knots;
  for (std::size_t k = 200; k < s.planned->time().size(); ++k) {
    time.push_back(s.planned->time()[k]);
    knots.push_back(s.planned->knots()[k]);
  }
  s.planned = std::make_shared<const JointSpline>(time, knots);
  s.start_time = s.planned->begin();
  s.start_position = knots.front().position;
  s.start_velocity = knots.front().velocity;
  s.duration = 0.5;
  int periods = 0;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint).run(published_gains(s), [&](const Observation& o) {
        EXPECT_NEAR(o.time, 9.0 + periods * s.control_period, 1e-12);
        EXPECT_EQ(o.control->state, kFollowPlan);
        if (periods++ == 0) {
          EXPECT_EQ(*o.q, knots.front().position);
          EXPECT_EQ(*o.qd, knots.front().velocity);
          EXPECT_GT(o.qd->norm(), 0.5);
          EXPECT_EQ(o.target_motion.position, s.targets[0].path.at(9.0).position);
        }
        return true;
      });
  EXPECT_EQ(periods, 250);
  EXPECT_EQ(result.end_time, 0.5) << "what was simulated, not the clock";
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << "no tool was to be tracked: " << result.reason;
}

TEST_F(PlannedRollout, TheMetricsAreThoseOfTheTrueJointsAgainstThePlan) {
  const Scenario s = scenario();
  double largest = 0.0;
  double squares = 0.0;
  int periods = 0;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint).run(published_gains(s), [&](const Observation& o) {
        const JointVector error = *o.q - s.planned->at(o.time).position;
        largest = std::max(largest, error.lpNorm<Eigen::Infinity>());
        squares += error.squaredNorm();
        ++periods;
        return true;
      });
  EXPECT_GT(largest, 1e-6);
  EXPECT_LT(largest, 1e-3);
  EXPECT_DOUBLE_EQ(result.metrics[Metric::kJointErrorMax], largest);
  EXPECT_NEAR(result.metrics[Metric::kJointErrorRms], std::sqrt(squares / (6 * periods)), 1e-15);
  EXPECT_TRUE(std::isnan(result.metrics[Metric::kPositionMax]));
  EXPECT_FALSE(applies(Metric::kPositionMax, s));
  EXPECT_TRUE(applies(Metric::kJointErrorMax, s));
  EXPECT_FALSE(applies(Metric::kJointErrorMax, base_));
  EXPECT_TRUE(applies(Metric::kPositionMax, base_));
}

// Without targets the tool is to stay as it is in the end; where it looks meanwhile means nothing.
TEST_F(PlannedRollout, OfAMotionAloneHasNoMetricsOfTheGaze) {
  folder_.write("plan.csv", test::plan_csv(*base_.robot, plan_));
  const Scenario alone = load_scenario(folder_.write(
      "alone.yaml",
      "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\nduration: planned\ntheta_start: {model_scale: 1}\n"));
  const Scenario with_targets = scenario();
  const auto metrics_of = [](const Scenario& s) {
    return Rollout(s, Stepper::kMidpoint, Engine::kNative).run(published_gains(s)).metrics;
  };
  const Metrics of_alone = metrics_of(alone), of_targets = metrics_of(with_targets);
  for (const Metric gaze : {Metric::kGazeRms, Metric::kGazeMax, Metric::kGazeRateErrorRms,
                            Metric::kGazeRateErrorMax, Metric::kGazeTimeOutside}) {
    EXPECT_TRUE(std::isnan(of_alone[gaze])) << name(gaze);
    EXPECT_FALSE(applies(gaze, alone)) << name(gaze);
    EXPECT_FALSE(std::isnan(of_targets[gaze])) << name(gaze);
    EXPECT_TRUE(applies(gaze, with_targets)) << name(gaze);
  }
  EXPECT_EQ(of_alone[Metric::kJointErrorMax], of_targets[Metric::kJointErrorMax]);
}

/// Largest |q - qd| of the quintic as a plan, and how far that run is from leaveSingularity's of the same
/// quintic.
struct AsPlanAndAsItself {
  double error = 0.0;
  double apart = 0.0;
};

AsPlanAndAsItself compared(Scenario planned, Scenario itself, double period) {
  planned.control_period = itself.control_period = period;
  planned.duration = itself.duration = 2.0;
  Gains gains = published_gains(planned);
  gains.joint_trajectory_duration = 2.0;
  AsPlanAndAsItself found;
  const auto a = test::joint_path(planned, gains, Stepper::kMidpoint);
  const auto b = test::joint_path(itself, gains, Stepper::kMidpoint);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const JointVector wanted =
        planned.planned->at(planned.start_time + static_cast<double>(k) * period).position;
    found.error = std::max(found.error, (a[k] - wanted).lpNorm<Eigen::Infinity>());
  }
  found.apart = test::largest_difference(a, b);
  return found;
}

TEST_F(PlannedRollout, AQuinticAsAPlanIsLeaveSingularitysMotionTheMoreSoTheShorterThePeriod) {
  plan_.step = 1e-3;  // the knots' own share, of second order, is 2e-6
  Scenario itself = base_;
  itself.theta.model_scale = 1.0;
  const Scenario planned = scenario();
  const AsPlanAndAsItself slow = compared(planned, itself, 2e-3);
  const AsPlanAndAsItself fast = compared(planned, itself, 5e-4);
  RecordProperty("apart", fmt::format("{:.2g} {:.2g}", slow.apart, fast.apart));
  RecordProperty("error", fmt::format("{:.2g} {:.2g}", slow.error, fast.error));
  EXPECT_LT(slow.apart, 1e-3);
  EXPECT_LT(fast.apart, 0.3 * slow.apart) << "first order in the period: half of one of jerk";
}

TEST_F(PlannedRollout, BothEnginesMoveAlike) {
  const Scenario s = scenario();
  const auto simbody = test::joint_path(s, published_gains(s), Stepper::kMidpoint, Engine::kSimbody);
  const auto native = test::joint_path(s, published_gains(s), Stepper::kMidpoint, Engine::kNative);
  ASSERT_EQ(simbody.size(), 1000U);
  EXPECT_LT(test::largest_difference(simbody, native), 1e-9);  // rounding, over 1000 periods
}

TEST_F(PlannedRollout, WhatIsLeftOfTheTimeGoesToTheScenariosOwnPath) {
  const Scenario s = scenario("moving_target", "8");
  std::vector<ControlState> states;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint).run(published_gains(s), [&](const Observation& o) {
        if (states.empty() || states.back() != o.control->state) {
          states.push_back(o.control->state);
          if (o.control->state == kReturnToTrajectory) {
            EXPECT_NEAR(o.time, 10.0, 1.5 * s.control_period);
          }
        }
        return true;
      });
  EXPECT_THAT(states, testing::ElementsAre(kFollowPlan, kReturnToTrajectory, kFollowTrajectory));
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_GT(result.metrics[Metric::kSamples], 0.0);
  EXPECT_LT(result.metrics[Metric::kPositionMax], 0.01);
  EXPECT_TRUE(applies(Metric::kPositionMax, s));
}

// A plan may end with a velocity and an acceleration. The arm stays nevertheless.
TEST_F(PlannedRollout, TheEndIsHeldWithoutTheVelocityAndAccelerationOfTheLastPoint) {
  folder_.write("plan.csv", test::plan_csv(*base_.robot, plan_));
  Scenario s = load_scenario(folder_.write(
      "alone.yaml",
      "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\ntheta_start: {model_scale: 1}\nduration: 4\n"));
  std::vector<MotionPoint<JointVector>> knots = s.planned->knots();
  std::vector<double> time = s.planned->time();
  knots.resize(knots.size() / 3);  // where it still speeds up
  time.resize(knots.size());
  ASSERT_GT(knots.back().velocity.norm(), 0.1);
  ASSERT_GT(knots.back().acceleration.norm(), 0.1);
  s.planned = std::make_shared<const JointSpline>(time, knots);
  double away = 1.0;
  Gains gains = published_gains(s);
  gains.adaptation_gain = 0.0;  // the model of the arm is right, and the jump of the velocity teaches nothing
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
        away = (*o.q - knots.back().position).cwiseAbs().maxCoeff();
        if (o.time >= time.back()) {
          EXPECT_TRUE(o.control->planned.velocity.isZero(0.0));
          EXPECT_TRUE(o.control->planned.acceleration.isZero(0.0));
        }
        return true;
      });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(away, 1e-3);
  EXPECT_GT(result.metrics[Metric::kGoalOvershoot], 1e-3) << "it cannot stop at once";
}

TEST_F(PlannedRollout, AloneItEndsWithTheJointsHeldWhereTheyAre) {
  folder_.write("plan.csv", test::plan_csv(*base_.robot, plan_));
  const std::string keys =
      "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\ntheta_start: {model_scale: 1}\n";
  const Scenario s = load_scenario(folder_.write("alone.yaml", keys + "duration: 6\n"));
  int held = 0;
  double away = 0.0, settled = 0.0, last = 0.0;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint, Engine::kNative).run(published_gains(s), [&](const Observation& o) {
        EXPECT_EQ(o.control->state, kFollowPlan);
        if (o.time < s.planned->end()) return true;
        ++held;
        EXPECT_TRUE(o.control->planned.velocity.isZero(0.0));
        away = (*o.q - plan_.goal).cwiseAbs().maxCoeff();
        if (away > s.goal_tolerance) settled = NAN;
        last = o.time;
        return true;
      });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_EQ(held, 2000) << "the seconds behind the plan's two";
  EXPECT_NEAR(last, 13.998, 1e-9);
  EXPECT_LT(away, 1e-4);
  EXPECT_EQ(result.metrics[Metric::kGoalSettlingTime], settled) << "always within the tolerance";
  EXPECT_LT(result.metrics[Metric::kGoalOvershoot], 1e-3);
  EXPECT_TRUE(std::isnan(result.metrics[Metric::kPositionMax]));
  EXPECT_TRUE(applies(Metric::kGoalSettlingTime, s));
  EXPECT_FALSE(applies(Metric::kPositionMax, s));
  // The joint errors are those of the motion, without the time after it.
  const Scenario ends = load_scenario(folder_.write("ends.yaml", keys));
  const Metrics of_motion =
      Rollout(ends, Stepper::kMidpoint, Engine::kNative).run(published_gains(s)).metrics;
  EXPECT_EQ(result.metrics[Metric::kJointErrorRms], of_motion[Metric::kJointErrorRms]);
  EXPECT_TRUE(std::isnan(of_motion[Metric::kGoalSettlingTime]));
  EXPECT_FALSE(applies(Metric::kGoalOvershoot, ends));
  // With any part of a task of its own, a scenario has to have it whole.
  const std::string half = folder_.write(
      "half.yaml",
      "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\ntargets: [{name: a, center: [1, 0, 0]}]\n"
      "theta_start: {model_scale: 1}\n");
  EXPECT_THAT([&] { load_scenario(half); },
              test::refused_at({.file = half, .line = 1, .key = "", .limit = "the key 'path'"}));
}

TEST_F(PlannedRollout, TheRecordHasPlanAndErrorOfEveryJointWhileItIsFollowed) {
  const Scenario s = scenario("moving_target", "2.1");
  Recorder recorder(s, 50);
  Rollout(s, Stepper::kMidpoint).run(published_gains(s), [&](const Observation& o) { return recorder(o); });
  recorder.write_csv(folder_ / "rollout.csv");
  const test::Csv csv = test::read_csv(folder_ / "rollout.csv");
  ASSERT_EQ(csv.rows.size(), 21U);
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    const auto at = [&](const std::string& column) { return std::stod(csv.at(row, column)); };
    const double time = at("time");
    const std::string joint = "joint/wrist_1_joint/";
    if (at("state") != static_cast<double>(kFollowPlan)) {
      EXPECT_GE(time, 10.0 - 1e-9);
      EXPECT_EQ(csv.at(row, joint + "error"), "") << "no figure is an empty cell";
      continue;
    }
    EXPECT_NEAR(at(joint + "planned"), s.planned->at(time).position[3], 1e-14);
    EXPECT_NEAR(at(joint + "error"), at(joint + "position") - at(joint + "planned"), 1e-14);
  }
  for (const Column& column : rollout_columns(base_))
    EXPECT_THAT(column.name, testing::Not(testing::EndsWith("/error")));
}

TEST_F(PlannedRollout, AnObstacleInterruptsItAndTheArmGoesOnToItsPath) {
  Scenario s = scenario("moving_target", "8");
  // From the side to the elbow as the goal has it and back, within the radius for a second or so.
  Poses poses;
  forward_kinematics(s.robot->chain, plan_.goal, poses);
  const Vec3 aside = Vec3::UnitZ().cross(poses.p_0B[2]).normalized();
  MovingObstacle obstacle{"ball", {poses.p_0B[2] + 1.2 * aside, 0.5, M_PI - 5.0, {}}};  // nearest at 10 s
  obstacle.path.terms = {{1, aside, Vec3::Zero()}};
  s.obstacles = {obstacle};
  std::vector<ControlState> states;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint).run(published_gains(s), [&](const Observation& o) {
        if (states.empty() || states.back() != o.control->state) states.push_back(o.control->state);
        return true;
      });
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  ASSERT_GE(states.size(), 3U);
  EXPECT_EQ(states[0], kFollowPlan);
  EXPECT_EQ(states[1], kAvoidObstacles);
  EXPECT_EQ(states[2], kReturnToTrajectory);
  EXPECT_EQ(states.back(), kFollowTrajectory);
  EXPECT_EQ(std::count(states.begin(), states.end(), kFollowPlan), 1);
}

TEST_F(PlannedRollout, ASwitchInTheFirstPeriodCounts) {
  // The plan holds still: the gaze never arrives, and the whole time counts.
  plan_.start = plan_.goal;
  Scenario s = scenario("target_switch");
  for (Eigen::Index i = 0; i < 3; ++i) s.targets[1].path.center[i] += 5.0;
  const Gains gains = published_gains(s);
  const RolloutResult switched = Rollout(s, Stepper::kMidpoint).run(gains);
  EXPECT_NEAR(switched.metrics[Metric::kReacquisitionTime], 2.0, 1e-9);
  s.switch_every = 0.0;
  const RolloutResult none = Rollout(s, Stepper::kMidpoint).run(gains);
  EXPECT_TRUE(std::isnan(none.metrics[Metric::kReacquisitionTime]));
}

}  // namespace planned_rollout_test
}  // namespace armtune::internal
