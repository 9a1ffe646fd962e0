// Rollouts in which the arm and the robot's drives are computed more often than the controller.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/plant/plant.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace plant_rate_test {

// Between two control periods the arm must move as a plant that takes the same steps under the same torque.
TEST(PlantRate, TheArmTakesSeveralStepsUnderTheSameTorque) {
  Scenario scenario = test::scenario_of("moving_target", 1.0);
  scenario.plant.rate = 1400.0;  // three steps in 2 ms
  for (const Engine engine : {Engine::kNative, Engine::kSimbody}) {
    const auto plant = make_plant(plant_model(scenario), Stepper::kMidpoint, engine);
    plant->set_state(scenario.start_position, JointVector::Zero(6));
    int periods = 0;
    Rollout(scenario, Stepper::kMidpoint, engine).run(test::quick_gains(scenario), [&](const Observation& o) {
      EXPECT_EQ(plant->q(), *o.q) << name(engine) << ", " << o.time;
      EXPECT_EQ(plant->qd(), *o.qd) << name(engine) << ", " << o.time;
      for (int step = 0; step < 3; ++step)
        plant->step(*o.applied, scenario.control_period / 3, step == 0 ? o.poses : nullptr);
      ++periods;
      return true;
    });
    EXPECT_EQ(periods, 500);
  }
}

/// A UR10 whose shoulder moves at 0.4 rad/s for 3 s.
class RampUnderDrives : public testing::Test {
 protected:
  RampUnderDrives() {
    folder_.write("ramp.csv",
                  "time,shoulder_pan_joint,shoulder_lift_joint,elbow_joint,wrist_1_joint,wrist_2_joint,"
                  "wrist_3_joint\n0,0,-1.2,1.4,-1.5,-1.5,0\n3,1.2,-1.2,1.4,-1.5,-1.5,0\n");
  }
  Scenario scenario(double period, int delay, double rate = 0.0) const {
    return load_scenario(folder_.write(
        "ramp.yaml",
        fmt::format("robot: ur10\nplanned: {{file: ramp.csv, segments: as_ros}}\ncontrol_period: {}\n"
                    "theta_start: {{model_scale: 1}}\nplant: {{torque_delay_periods: {}, rate: {}}}\n",
                    period, delay, rate)));
  }
  /// Time by which the first joint is behind the ramp in the end [s].
  static double lag(const Scenario& scenario, const char* controller, double* largest_torque = nullptr) {
    Gains gains = convert_gains(controller_kind(controller), test::published_gains(scenario), *scenario.robot,
                                scenario.start_position);
    double behind = NAN;
    const RolloutResult result =
        Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
          behind = (o.control->planned.position[0] - (*o.q)[0]) / 0.4;
          if (largest_torque != nullptr) {
            o.each_instant([&](double, const JointVector&, const JointVector&, const JointVector& commanded,
                               const JointVector&) {
              *largest_torque = std::max(*largest_torque, commanded.cwiseAbs().maxCoeff());
            });
          }
          EXPECT_EQ(*o.applied, o.control->torque) << "the drives' torques are not late";
          return true;
        });
    EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    return behind;
  }

  test::TemporaryFolder folder_;
};

// The servo's look-ahead time, half a period of the stream, and the delay of the commands.
TEST_F(RampUnderDrives, StreamedPositionsAreLateByLookAheadHalfAPeriodAndDelay) {
  for (const double period : {0.002, 0.008}) {
    for (const int delay : {0, 3}) {
      // At its start, an instant of a period, q_s is compared with the position that is sent then.
      EXPECT_NEAR(lag(scenario(period, delay), "position_streaming"), 0.1 + (delay + 0.5) * period,
                  0.5 * period + 2e-4)
          << period << ", " << delay;
    }
    EXPECT_NEAR(
        lag(scenario(period, 3), "position_streaming") - lag(scenario(period, 0), "position_streaming"),
        3.0 * period, 2e-5);
  }
}

// The drives run at 1 kHz. At the controller's 100 Hz, and with its delay, they would shake.
TEST_F(RampUnderDrives, DrivesAreStableUnderASlowController) {
  double torque = 0.0, torque_of_fast = 0.0;
  lag(scenario(0.01, 2), "joint_trajectory_controller_velocity", &torque);
  lag(scenario(0.001, 0), "joint_trajectory_controller_velocity", &torque_of_fast);
  EXPECT_LT(torque, 1.5 * torque_of_fast);
  EXPECT_EQ(lag(scenario(0.01, 0, 1000.0), "position_streaming"),
            lag(scenario(0.01, 0), "position_streaming"))
      << "the rate is 1 kHz unless the scenario gives another";
  EXPECT_NE(lag(scenario(0.01, 0, 2000.0), "position_streaming"),
            lag(scenario(0.01, 0), "position_streaming"));
}

// The metrics once more in a few lines, from what an observer sees of the true arm in every period of the
// drives. Every streamed position makes a step of the torque, which only these periods show.
TEST_F(RampUnderDrives, MetricsSeeTheDrivesBetweenControlPeriods) {
  Scenario s = scenario(0.008, 1);
  s.plant.position_noise = 1e-4;
  s.plant.velocity_noise = 1e-3;
  s.duration = 4.0;  // a second at the end of the ramp
  Gains gains = convert_gains(controller_kind("position_streaming"), test::published_gains(s), *s.robot,
                              s.start_position);
  own(gains, "servo_lookahead_time")[0] = 0.05;  // damping ratio of 0.43
  std::vector<JointVector> torques, velocities;
  double effort = 0.0, speed = 0.0, settled = NAN, overshoot = 0.0, last = -1.0;
  const RolloutResult result =
      Rollout(s, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
        EXPECT_EQ(o.between.size(), o.time == 0.0 ? 0U : 7U);
        o.each_instant([&](double time, const JointVector&, const JointVector& qd,
                           const JointVector& commanded, const JointVector& torque) {
          EXPECT_NEAR(time, last < 0.0 ? 0.0 : last + 0.001, 1e-9);
          last = time;
          torques.push_back(torque);
          velocities.push_back(qd);
          effort = std::max(effort, commanded.cwiseQuotient(s.robot->effort_limits()).cwiseAbs().maxCoeff());
          speed = std::max(speed, qd.cwiseQuotient(s.robot->velocity_limits()).cwiseAbs().maxCoeff());
        });
        if (o.time < s.planned->end()) return true;
        const JointVector away = *o.q - s.planned->at(3.0).position;
        if (away.cwiseAbs().maxCoeff() > s.goal_tolerance) {
          settled = NAN;
        } else if (std::isnan(settled)) {
          settled = o.time - s.planned->end();
        }
        overshoot = std::max(overshoot, away[0]);  // the other joints do not move
        return true;
      });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  double squares = 0.0, acceleration = 0.0, jerk = 0.0;
  for (std::size_t k = 1; k < torques.size(); ++k) {
    squares += (torques[k] - torques[k - 1]).squaredNorm() / 1e-6;
    acceleration = std::max(acceleration, (velocities[k] - velocities[k - 1]).cwiseAbs().maxCoeff() / 1e-3);
    if (k > 1)
      jerk = std::max(
          jerk, (velocities[k] - 2.0 * velocities[k - 1] + velocities[k - 2]).cwiseAbs().maxCoeff() / 1e-6);
  }
  const Metrics& m = result.metrics;
  const double rate = std::sqrt(squares / static_cast<double>(torques.size() - 1));
  EXPECT_NEAR(m[Metric::kEffortRateRms], rate, 1e-9 * rate);
  EXPECT_NEAR(m[Metric::kJointAccelerationMax], acceleration, 1e-9 * acceleration);
  EXPECT_NEAR(m[Metric::kJointJerkMax], jerk, 1e-9 * jerk);
  EXPECT_NEAR(m[Metric::kJointEffortMaxRatio], effort, 1e-12);
  EXPECT_NEAR(m[Metric::kJointVelocityMaxRatio], speed, 1e-12);
  EXPECT_GT(settled, 0.05);
  EXPECT_NEAR(m[Metric::kGoalSettlingTime], settled, 1e-9);
  EXPECT_GT(overshoot, 1e-3);
  EXPECT_NEAR(m[Metric::kGoalOvershoot], overshoot, 1e-9);
}

// The robot's file gives the rate of its drives, the scenario that of the arm: drives at 500 Hz, and six
// steps of the arm under each of their torques.
TEST_F(RampUnderDrives, DrivesMayHaveARateOfTheirOwn) {
  Scenario s = scenario(0.008, 0, 3000.0);
  s.duration = 1.0;
  RobotModel robot = *s.robot;
  robot.drive_rate = 500.0;
  s.robot = std::make_shared<const RobotModel>(robot);
  const Gains gains = convert_gains(controller_kind("position_streaming"), test::published_gains(s), *s.robot,
                                    s.start_position);
  const auto plant = make_plant(plant_model(s), Stepper::kMidpoint, Engine::kNative);
  plant->set_state(s.start_position,
                   s.start_velocity.size() > 0 ? s.start_velocity : JointVector(JointVector::Zero(6)));
  constexpr double kStep = 0.008 / 24;
  JointVector torque;
  int periods = 0;
  Rollout(s, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
    EXPECT_EQ(o.between.size(), o.time == 0.0 ? 0U : 3U);
    if (periods > 0) {
      for (int step = 1; step < 6; ++step) plant->step(torque, kStep);
      for (const DriveInstant& at : o.between) {
        EXPECT_EQ(plant->q(), at.q) << at.time;
        EXPECT_EQ(plant->qd(), at.qd) << at.time;
        for (int step = 0; step < 6; ++step) plant->step(at.torque, kStep);
      }
    }
    EXPECT_EQ(plant->q(), *o.q) << o.time;
    EXPECT_EQ(plant->qd(), *o.qd) << o.time;
    torque = *o.applied;
    plant->step(torque, kStep, o.poses);
    ++periods;
    return true;
  });
  EXPECT_EQ(periods, 125);
}

// The robot's values reach the rollout: those that armtune assumes change nothing, and others do.
TEST_F(RampUnderDrives, ValuesOfTheRobotsFileAct) {
  const auto error = [&](const auto& change) {
    Scenario s = scenario(0.002, 0);
    RobotModel robot = *s.robot;
    change(robot);
    s.robot = std::make_shared<const RobotModel>(robot);
    const Gains gains = convert_gains(controller_kind("position_streaming"), test::published_gains(s),
                                      *s.robot, s.start_position);
    return Rollout(s, Stepper::kMidpoint, Engine::kNative).run(gains).metrics[Metric::kJointErrorRms];
  };
  const double assumed = error([](RobotModel&) {});
  EXPECT_EQ(error([](RobotModel& r) { r.drive_position_gain = JointVector::Constant(6, 15.0); }), assumed);
  EXPECT_EQ(error([](RobotModel& r) { r.drive_torque_rate = JointVector::Constant(6, 1e9); }), assumed);
  EXPECT_EQ(error([](RobotModel& r) { r.drive_delay = JointVector::Zero(6); }), assumed);
  EXPECT_EQ(error([](RobotModel& r) { r.drive_rate = 1000.0; }), assumed);
  EXPECT_NE(error([](RobotModel& r) { r.drive_position_gain = JointVector::Constant(6, 5.0); }), assumed);
  EXPECT_NE(error([](RobotModel& r) { r.drive_torque_rate = JointVector::Constant(6, 100.0); }), assumed);
  EXPECT_NE(error([](RobotModel& r) { r.drive_delay = JointVector::Constant(6, 0.002); }), assumed);
  EXPECT_NE(error([](RobotModel& r) { r.drive_rate = 2000.0; }), assumed);
}

TEST_F(RampUnderDrives, TheRateOfAScenarioIsChecked) {
  EXPECT_EQ(scenario(0.002, 0, 4000.0).plant.rate, 4000.0);
  EXPECT_THROW(scenario(0.002, 0, -1.0), InputError);
}

}  // namespace plant_rate_test
}  // namespace armtune::internal
