// The drives of arms in lanes: each arm has its own, with the numbers that it has alone.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "tests/sim/support/lanes.hpp"
#include "tests/sim/support/law_jobs.hpp"

namespace armtune::internal {
namespace drive_lanes_test {

using test::add_hopeless_job;
using test::add_jobs_with;
using test::add_perturbed_jobs;
using test::alone;
using test::bits;
using test::expect_different_and_the_same;
using test::expect_the_same;
using test::gains_of;
using test::job_of;
using test::scenario_of;
using test::with_plan;
using test::with_robot;

/// Both kinds of controllers that command drives.
class DriveLanesOf : public testing::TestWithParam<const char*> {
 protected:
  LaneJob job(const Scenario& scenario) const { return job_of(scenario, gains_of(scenario, GetParam())); }
  LaneKind kind(const Scenario& scenario) const {
    return lane_kind(scenario, Stepper::kMidpoint, 0, lane_law(gains_of(scenario, GetParam())).value());
  }
};

TEST_P(DriveLanesOf, EachArmHasItsGainsLimitsRateAndDelay) {
  const Scenario scenario = with_plan(scenario_of("moving_target", 2.5));
  std::vector<LaneJob> jobs = {job(scenario)};
  ASSERT_EQ(alone(jobs[0]).status, RolloutStatus::kCompleted);
  const auto add = [&](const auto& change) { jobs.push_back(job(with_robot(scenario, change))); };
  add([](RobotModel& robot) { robot.compensates_gravity = true; });
  add([](RobotModel& robot) { robot.drive_velocity_gain = JointVector::Constant(6, 800.0); });
  add([](RobotModel& robot) { robot.drive_velocity_integral = JointVector::Constant(6, 300.0); });
  add([](RobotModel& robot) { robot.drive_torque_rate = JointVector::Constant(6, 700.0); });
  add([](RobotModel& robot) { robot.drive_delay = JointVector::LinSpaced(6, 0.0, 0.0035); });
  add([](RobotModel& robot) {
    robot.compensates_gravity = true;
    robot.drive_torque_rate = JointVector::Constant(6, 2000.0);
    robot.drive_delay = JointVector::Constant(6, 0.0015);
  });
  add([](RobotModel& robot) {
    for (JointInfo& joint : robot.joints) joint.limits.velocity *= 0.1;
  });
  add([](RobotModel& robot) {
    for (JointInfo& joint : robot.joints) joint.limits.effort *= 0.4;
  });
  const auto saturated = [](const LaneJob& one) {
    return alone(one).metrics[Metric::kJointEffortSaturatedPeriods];
  };
  EXPECT_GT(saturated(jobs.back()), 10.0 + saturated(jobs[0]));
  expect_different_and_the_same(jobs);
}

TEST_P(DriveLanesOf, NoiseDelayDisturbancesAndEarlyEndsAreEachArmsOwn) {
  const Scenario scenario = with_plan(scenario_of("realistic_moving_target", 2.5));
  std::vector<LaneJob> jobs;
  for (const int delay : {0, 1, 3}) {
    Scenario late = scenario;
    late.plant.torque_delay_periods = delay;
    jobs.push_back(job(late));
  }
  for (const double noise : {0.0, 2e-3}) {
    Scenario noisy = scenario;
    noisy.plant.velocity_noise = noise;
    noisy.plant.position_noise = 0.0;
    jobs.push_back(job(noisy));
  }
  add_perturbed_jobs(scenario, jobs);
  add_hopeless_job(jobs);
  expect_different_and_the_same(jobs);
}

// The last row's drives are slower than the controller: they compute one torque in each control period.
TEST_P(DriveLanesOf, DrivesAndPlantHaveRatesOfTheirOwn) {
  struct Rates {
    double drives, plant;          // Hz, lowest; 0: none given
    int drive_steps, plant_steps;  // in a control period of 4 ms, and in one of these
  };
  std::vector<std::uint64_t> before;
  for (const Rates& rates : {Rates{0.0, 0.0, 4, 1},
                             {0.0, 1400.0, 6, 1},
                             {700.0, 0.0, 3, 1},
                             {700.0, 2300.0, 3, 4},
                             {100.0, 700.0, 1, 3}}) {
    Scenario scenario = with_robot(with_plan(scenario_of("moving_target", 2.0)),
                                   [&](RobotModel& robot) { robot.drive_rate = rates.drives; });
    scenario.control_period = 0.004;
    scenario.plant.rate = rates.plant;
    EXPECT_EQ(kind(scenario).drive_steps, rates.drive_steps);
    EXPECT_EQ(kind(scenario).plant_steps, rates.plant_steps);
    const LaneJob first = job(scenario);
    scenario.plant.payload.mass = 2.0;  // kg
    std::vector<LaneJob> jobs = {first, job(scenario), first};
    jobs.back().gains.joint_trajectory_duration *= 1.5;
    expect_the_same(jobs);
    EXPECT_NE(bits(alone(first).metrics), before);
    before = bits(alone(first).metrics);
  }
  for (const Stepper stepper : {Stepper::kRungeKutta4, Stepper::kSemiImplicitEuler}) {
    expect_the_same({job(with_plan(scenario_of("moving_target", 1.0)))}, stepper);
  }
}

TEST_P(DriveLanesOf, ShareLanesOnlyWithDrivesOfTheSameRate) {
  const Scenario scenario = scenario_of("moving_target", 1.0);
  const Scenario faster = with_robot(scenario, [](RobotModel& robot) { robot.drive_rate = 3000.0; });
  EXPECT_FALSE(kind(scenario) == kind(faster));
  RolloutLanes lanes(kind(scenario), 2);
  EXPECT_THROW(lanes.start(0, job(faster)), InputError);
  lanes.start(0, job(scenario));
  EXPECT_EQ(lanes.busy(), 1);
}

// The velocity of this arm is not finite in the middle of a control period.
TEST_P(DriveLanesOf, AnArmThatDivergesBetweenControlPeriodsLeavesItsNeighboursAlone) {
  const Scenario scenario = with_plan(scenario_of("moving_target", 1.5));
  std::vector<LaneJob> jobs = {job(scenario), job(scenario), job(scenario)};
  jobs[1] = job(with_robot(scenario, [](RobotModel& robot) {
    robot.drive_velocity_gain = JointVector::Constant(6, 1e250);
    for (JointInfo& joint : robot.joints) joint.limits.effort = 1e300;
  }));
  jobs[2].gains.joint_trajectory_duration *= 2.0;
  ASSERT_EQ(alone(jobs[1]).status, RolloutStatus::kDiverged);
  ASSERT_NE(alone(jobs[1]).reason.find("not finite"), std::string::npos);
  expect_the_same(jobs);
}

INSTANTIATE_TEST_SUITE_P(Laws, DriveLanesOf,
                         testing::Values("joint_trajectory_controller_velocity", "position_streaming"));

// The position loops and the servo are only in front of drives that take positions. The last joint begins
// nearly a turn away from its plan, and takes the shorter way if it has no limits.
TEST(DriveLanes, EachArmHasItsServoAndPositionLoops) {
  const Scenario scenario = with_plan(scenario_of("moving_target", 2.0));
  const LaneJob first = job_of(scenario, gains_of(scenario, "position_streaming"));
  std::vector<LaneJob> jobs = {first};
  add_jobs_with({{"servo_gain", 900.0}, {"servo_lookahead_time", 0.04}, {"servo_position_gain", 25.0}}, jobs);
  jobs.push_back(job_of(
      with_robot(scenario,
                 [](RobotModel& robot) { robot.drive_position_gain = JointVector::LinSpaced(6, 5.0, 30.0); }),
      first.gains));
  Scenario turned =
      with_robot(scenario, [](RobotModel& robot) { robot.joints.back().limits.has_position = false; });
  turned.start_position[5] += 1.9 * M_PI;
  jobs.push_back(job_of(turned, first.gains));
  expect_different_and_the_same(jobs);
}

}  // namespace drive_lanes_test
}  // namespace armtune::internal
