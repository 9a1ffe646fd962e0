// Every law that runs in lanes gives each arm the numbers that it has alone, whatever the settings of its
// neighbours are.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/sim/support/lanes.hpp"
#include "tests/sim/support/law_jobs.hpp"

namespace armtune::internal {
namespace law_lanes_test {

using test::add_hopeless_job;
using test::add_jobs_with;
using test::add_perturbed_jobs;
using test::alone;
using test::bits;
using test::expect_different_and_the_same;
using test::expect_the_same;
using test::gains_of;
using test::job_of;
using test::quick_gains;
using test::scenario_of;
using test::with_plan;
using test::with_robot;

/// Multiplies the gains of the control loop. The servo is what a stream of positions can change in its loop.
void multiply_loop_gains(Gains& gains, double factor) {
  scale_loop_gains(gains, factor);
  if (gains.controller == "position_streaming") own(gains, "servo_gain") *= factor;
}

/// Every law that is written for several arms, on arms of six, seven and five joints, with gaze, obstacles
/// and noise.
class LawLanesOf : public testing::TestWithParam<const char*> {};

TEST_P(LawLanesOf, AreTheRolloutsAlone) {
  for (const char* name : {"moving_target", "realistic_target_switch", "obstacle_pass", "panda_moving_target",
                           "youbot_moving_target"}) {
    std::vector<LaneJob> jobs;
    for (int i = 0; i < 3; ++i) {
      Scenario scenario = scenario_of(name, 6.0 + i);
      scenario.theta = {};
      scenario.theta.model_scale = 1.0;  // most of these laws learn nothing
      Gains gains = gains_of(scenario, GetParam());
      multiply_loop_gains(gains, 1.0 - 0.1 * i);
      jobs.push_back(job_of(scenario, gains));
    }
    SCOPED_TRACE(name);
    EXPECT_NE(alone(jobs[0]).status, RolloutStatus::kDiverged) << "not only a fall";
    expect_the_same(jobs);
  }
}

TEST_P(LawLanesOf, TheGainsMatter) {
  Scenario scenario = scenario_of("moving_target", 6.0);
  scenario.theta.model_scale = 1.0;
  Gains gains = convert_gains(controller_kind(GetParam()), quick_gains(scenario), *scenario.robot,
                              scenario.start_position);
  ASSERT_TRUE(lane_law(gains).has_value());
  const LaneJob as_it_is = job_of(scenario, gains);
  multiply_loop_gains(gains, 0.7);
  EXPECT_NE(bits(alone(as_it_is).metrics), bits(alone(job_of(scenario, gains)).metrics));
}

TEST_P(LawLanesOf, AllocateNothingInAPeriod) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  const Scenario scenario = with_plan(scenario_of("moving_target", 6.0));
  const LaneJob job = job_of(scenario, gains_of(scenario, GetParam()));
  ASSERT_EQ(alone(job).status, RolloutStatus::kCompleted);
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, 0, lane_law(job.gains).value()), 2);
  for (int lane = 0; lane < 2; ++lane) lanes.start(lane, job);
  const RolloutLanes::Finished finished = [](int, RolloutResult&&) {};
  lanes.step(finished);
  const long first = test::allocations();
  for (int k = 2; k < scenario.periods(); ++k) lanes.step(finished);
  EXPECT_EQ(test::allocations(), first);
  EXPECT_EQ(lanes.busy(), 2);
}

INSTANTIATE_TEST_SUITE_P(Laws, LawLanesOf,
                         testing::Values("adaptive", "computed_torque", "joint_pd", "impedance",
                                         "joint_trajectory_controller", "joint_impedance",
                                         "cartesian_impedance", "joint_trajectory_controller_velocity",
                                         "position_streaming"));

// A robot that holds its own weight, so that clamps below the weight do not let the arm fall.
TEST(LawLanes, AJointTrajectoryControllerClampsEachArmsIntegralAndOutput) {
  Scenario scenario = with_robot(with_plan(scenario_of("moving_target", 4.0)),
                                 [](RobotModel& robot) { robot.compensates_gravity = true; });
  scenario.plant.payload.mass = 4.0;  // kg: what the integrals work against
  std::vector<LaneJob> jobs;
  for (int anti_windup = 0; anti_windup < 5; ++anti_windup) {
    Gains gains = gains_of(scenario, "joint_trajectory_controller");
    own(gains, "jtc_i") *= 20.0;
    own(gains, "jtc_i_clamp").setConstant(15.0);
    own(gains, "jtc_u_clamp_max").setConstant(30.0);
    own(gains, "jtc_u_clamp_min").setConstant(25.0);
    own(gains, "jtc_ff_velocity_scale").setConstant(2.0);
    own(gains, "jtc_antiwindup").setConstant(anti_windup);
    jobs.push_back(job_of(scenario, gains));
  }
  EXPECT_NE(alone(jobs[2]).status, RolloutStatus::kDiverged) << "not only a fall";
  LaneJob other = jobs[0];
  own(other.gains, "jtc_distro").setConstant(1.0);  // Humble feeds forward another period's velocity
  jobs.push_back(other);
  other = jobs[1];
  own(other.gains, "jtc_i_clamp_min").setConstant(2.0);
  jobs.push_back(other);
  other = jobs[4];
  own(other.gains, "jtc_tracking_time").setConstant(0.05);
  jobs.push_back(other);
  other = jobs[3];
  own(other.gains, "jtc_error_deadband").setConstant(0.01);
  jobs.push_back(other);
  add_hopeless_job(jobs);
  add_perturbed_jobs(scenario, jobs);
  // Its neighbours' weights are held, its own is not.
  scenario = with_robot(scenario, [](RobotModel& robot) { robot.compensates_gravity = false; });
  jobs.push_back(job_of(scenario, jobs[0].gains));
  expect_different_and_the_same(jobs);
}

// The last joint begins a turn away from its plan. It stays there if the error is wrapped.
TEST(LawLanes, AJointTrajectoryControllerWrapsEachArmsErrorAsItsDistributionSays) {
  Scenario scenario = with_robot(with_plan(scenario_of("moving_target", 2.0)),
                                 [](RobotModel& robot) { robot.joints.back().limits.has_position = false; });
  const Scenario near = scenario;
  scenario.start_position.tail(1).array() += 2.0 * M_PI;
  std::vector<LaneJob> jobs;
  for (const double distro : {0.0, 1.0, 2.0}) {
    Gains gains = gains_of(scenario, "joint_trajectory_controller");
    own(gains, "jtc_distro").setConstant(distro);
    jobs.push_back(job_of(scenario, gains));
    own(gains, "jtc_angle_wraparound").setOnes();  // only Humble has this parameter
    jobs.push_back(job_of(scenario, gains));
    jobs.push_back(job_of(near, gains));
  }
  const auto speed = [&jobs](std::size_t i) {
    return alone(jobs[i]).metrics[Metric::kJointVelocityMaxRatio];
  };
  EXPECT_NEAR(speed(0), speed(2), 1e-6 * speed(2)) << "Jazzy: joints without limits";
  EXPECT_GT(speed(3), 1.5 * speed(5)) << "Humble, without the parameter";
  EXPECT_NEAR(speed(4), speed(5), 1e-6 * speed(5)) << "Humble, with it";
  EXPECT_NEAR(speed(6), speed(8), 1e-6 * speed(8)) << "Noetic: all joints";
  expect_the_same(jobs);
}

TEST(LawLanes, AJointImpedanceHasItsFactorsFilterAndRateInEachArm) {
  Scenario scenario = with_plan(scenario_of("moving_target", 4.0));
  scenario.plant.velocity_noise = 1e-3;
  const LaneJob first = job_of(scenario, gains_of(scenario, "joint_impedance"));
  ASSERT_EQ(alone(first).status, RolloutStatus::kCompleted);
  std::vector<LaneJob> jobs = {first};
  add_jobs_with({{"joint_impedance_velocity_factor", 0.0},
                 {"joint_impedance_coriolis_factor", 0.0},
                 {"joint_impedance_filter", 0.9},
                 {"joint_impedance_torque_rate", 300.0},
                 {"joint_impedance_damping_ratio", 0.5}},
                jobs);
  expect_different_and_the_same(jobs);
}

// Seven joints, so that the null space is more than the damped projector's rest. The arms begin to track
// their tools at different times.
TEST(LawLanes, ACartesianImpedanceFiltersEachArmsToolFromWhereItBegins) {
  Scenario scenario = scenario_of("panda_realistic_moving_target", 6.0);
  scenario.theta = {};
  scenario.theta.model_scale = 1.0;
  const LaneJob first = job_of(scenario, gains_of(scenario, "cartesian_impedance"));
  std::vector<LaneJob> jobs = {first};
  add_jobs_with({{"cartesian_impedance_damping_ratio", 0.7},
                 {"cartesian_impedance_damping", 4.0},
                 {"cartesian_impedance_nullspace_k", 0.0},
                 {"cartesian_impedance_filter", 0.95},
                 {"cartesian_impedance_torque_rate", 200.0}},
                jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    jobs[i].gains.joint_trajectory_duration += 0.2 * static_cast<double>(i);
  EXPECT_NE(alone(first).status, RolloutStatus::kDiverged) << "not only a fall";
  expect_different_and_the_same(jobs);
}

}  // namespace law_lanes_test
}  // namespace armtune::internal
