#include "sim/lanes/rollout_lanes.hpp"

#include <gtest/gtest.h>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/robot/link_radius.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tests/sim/support/lanes.hpp"

namespace armtune::internal {
namespace rollout_lanes_test {

using test::alone;
using test::bits;
using test::expect_the_same;
using test::job_of;
using test::quick_gains;
using test::scenario_of;

/// Every gain a bit larger in each candidate.
std::vector<LaneJob> candidates(const Scenario& scenario, int count) {
  const auto prepared = std::make_shared<const PreparedScenario>(scenario);
  std::vector<LaneJob> jobs;
  for (int i = 0; i < count; ++i) {
    Gains gains = quick_gains(scenario);
    gains.task_space_gains_p *= 1.0 + 0.05 * i;
    gains.slerpDurationErrorGain *= 1.0 + 0.1 * i;
    gains.adaptation_gain *= 1.0 + 0.02 * i;
    jobs.push_back({prepared, gains});
  }
  return jobs;
}

TEST(RolloutLanes, EveryRolloutIsTheOneAloneToTheBit) {
  std::vector<LaneJob> jobs = candidates(scenario_of("moving_target", 6.0), 5);
  // Others beside them, longer and shorter, which begin and end when they do.
  for (const auto& [name, duration] :
       {std::pair{"step_position", 9.0}, {"fixed_target", 5.0}, {"target_switch", 9.0}}) {
    const Scenario other = scenario_of(name, duration);
    jobs.push_back(job_of(other, quick_gains(other)));
  }
  expect_the_same(jobs);
}

TEST(RolloutLanes, StepAsTheStepperDoesAlone) {
  for (const Stepper stepper : {Stepper::kRungeKutta4, Stepper::kSemiImplicitEuler}) {
    expect_the_same(candidates(scenario_of("moving_target", 3.0), 3), stepper);
  }
  EXPECT_THROW(lane_kind(scenario_of("moving_target", 3.0), Stepper::kReference, 0), InputError);
}

TEST(RolloutLanes, TakeSeveralStepsOfTheArmInAControlPeriod) {
  Scenario scenario = scenario_of("moving_target", 3.0);
  const std::vector<LaneJob> coarse = candidates(scenario, 1);
  scenario.plant.rate = 1400.0;  // three steps in 2 ms
  const std::vector<LaneJob> fine = candidates(scenario, 3);
  expect_the_same(fine);
  EXPECT_NE(bits(alone(fine[0]).metrics), bits(alone(coarse[0]).metrics));
  EXPECT_FALSE(lane_kind(scenario, Stepper::kMidpoint, 0) ==
               lane_kind(scenario_of("moving_target", 3.0), Stepper::kMidpoint, 0))
      << "arms with other steps must not share a register";
}

TEST(RolloutLanes, NoiseCameraDelayFrictionAndObstaclesAreEachArmsOwn) {
  const Scenario scenario = scenario_of("realistic_obstacle_pass", 8.0);
  ASSERT_GT(scenario.plant.position_noise, 0.0);
  std::vector<LaneJob> jobs = candidates(scenario, 3);
  const Scenario without = scenario_of("realistic_fixed_target", 6.0);
  ASSERT_LT(without.obstacles.size(), scenario.obstacles.size());
  jobs.push_back(job_of(without, quick_gains(without)));
  for (int sample = 0; sample < 4; ++sample) {
    const Scenario other = perturbed(scenario, Perturbation{}, 7, static_cast<std::uint64_t>(sample));
    jobs.push_back(job_of(other, quick_gains(scenario)));
  }
  expect_the_same(jobs);
}

TEST(RolloutLanes, StiffFrictionIsIntegratedArmByArm) {
  Scenario scenario = scenario_of("moving_target", 4.0);
  RobotModel robot = *scenario.robot;
  robot.chain.rotor_inertia.tail(2).setConstant(0.01);
  scenario.robot = std::make_shared<const RobotModel>(robot);
  std::vector<LaneJob> jobs;
  for (const double coulomb : {0.0, 0.3, 3.0, 10.0}) {
    scenario.plant.coulomb_friction = JointVector::Constant(6, coulomb);
    jobs.push_back(job_of(scenario, quick_gains(scenario)));
  }
  for (const Stepper stepper : {Stepper::kMidpoint, Stepper::kSemiImplicitEuler, Stepper::kRungeKutta4}) {
    expect_the_same(jobs, stepper);
  }
}

TEST(RolloutLanes, ClearanceCountsEachArmsToolWhetherItIsMeasuredExactlyOrNot) {
  for (const char* name : {"moving_target", "realistic_moving_target"}) {
    Scenario scenario = scenario_of(name, 5.0);
    Path before_the_tool;
    before_the_tool.center = scenario.path.at(4.0).position + Vec3(0.0, 0.02, 0.0);
    scenario.obstacles = {{"beside the circle", before_the_tool, 0.005}};
    std::vector<LaneJob> jobs = candidates(scenario, 3);
    for (LaneJob& job : jobs) job.gains.obstacleInfluenceRadius = 0.08;  // m: the tool alone comes that near
    EXPECT_LT(alone(jobs[0]).metrics[Metric::kObstacleMinClearance], 0.08) << name;
    expect_the_same(jobs);
  }
}

TEST(RolloutLanes, LinksAndBodiesAreEachArmsOwn) {
  Scenario scenario = scenario_of("realistic_obstacle_pass", 8.0);
  scenario.obstacles[0].radius = 0.1;
  RobotModel robot = with_link_surfaces(*scenario.robot);
  scenario.robot = std::make_shared<const RobotModel>(robot);
  std::vector<LaneJob> jobs = candidates(scenario, 2);
  scenario.obstacles.pop_back();
  robot.chain.link_radius *= 1.5;
  scenario.robot = std::make_shared<const RobotModel>(robot);
  jobs.push_back(job_of(scenario, jobs[0].gains));
  expect_the_same(jobs);
  const Scenario joints = scenario_of("realistic_obstacle_pass", 8.0);
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, 3), 2);
  EXPECT_THROW(lanes.start(0, job_of(joints, jobs[0].gains)), InputError);
}

TEST(RolloutLanes, ACameraSeesItsOwnTargets) {
  std::vector<LaneJob> jobs = candidates(scenario_of("realistic_camera_target", 5.0), 2);
  ASSERT_TRUE(jobs[0].scenario->scenario.camera);
  jobs.push_back(job_of(scenario_of("moving_target", 5.0), jobs[0].gains));
  expect_the_same(jobs);
}

TEST(RolloutLanes, TheExtendedLawDecidesArmByArm) {
  const Scenario scenario = scenario_of("realistic_target_switch", 6.0);
  Gains extended = load_gains("extended", joint_names(*scenario.robot));
  std::vector<LaneJob> jobs = {job_of(scenario, quick_gains(scenario))};
  for (int i = 0; i < 3; ++i) {
    extended.velocity_margin = 0.5 + 0.1 * i;
    extended.adaptation_leakage = 0.1 * i;
    extended.adaptation_inertia_leakage = i == 2 ? 0.2 : 0.0;
    extended.adaptation_projection = i != 1;
    extended.adaptation_filter = 5.0 * i;
    extended.roll_centering_gain = 0.1 * i;
    jobs.push_back(job_of(scenario, extended));
  }
  expect_the_same(jobs);
}

TEST(RolloutLanes, EveryInvalidLinkOfEveryArmIsProjected) {
  const Scenario scenario = scenario_of("realistic_target_switch", 3.0);
  Gains quick = load_gains("extended", joint_names(*scenario.robot));
  quick.adaptation_leakage = quick.adaptation_inertia_leakage = quick.adaptation_filter = 0.0;
  std::vector<LaneJob> jobs;
  for (const double gain : {0.3, 1.0, 3.0}) {
    quick.adaptation_gain = gain;
    quick.adaptation_projection = true;
    jobs.push_back(job_of(scenario, quick));
    quick.adaptation_projection = false;
    EXPECT_NE(alone(jobs.back()).metrics[Metric::kPositionMax],
              alone(job_of(scenario, quick)).metrics[Metric::kPositionMax])
        << "or nothing is projected";
  }
  expect_the_same(jobs);
}

TEST(RolloutLanes, OneThatDivergesOrEndsEarlyLeavesItsNeighboursAlone) {
  const Scenario scenario = scenario_of("moving_target", 5.0);
  std::vector<LaneJob> jobs = candidates(scenario, 4);
  jobs[1].gains.task_space_gains_d *= -3.0;
  jobs[2].limits = {{Metric::kJointVelocityMaxRatio, 0.2}};
  ASSERT_EQ(alone(jobs[1]).status, RolloutStatus::kDiverged);
  ASSERT_EQ(alone(jobs[2]).status, RolloutStatus::kHopeless);
  expect_the_same(jobs);
}

TEST(RolloutLanes, StartOnlyWhatIsOfTheirKind) {
  const Scenario scenario = scenario_of("moving_target", 1.0);
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, 0), 2);
  Scenario slower = scenario;
  slower.control_period *= 2.0;
  for (const Scenario& other : {scenario_of("obstacle_pass"), slower}) {
    EXPECT_THROW(lanes.start(0, job_of(other, quick_gains(other))), InputError);
  }
  EXPECT_EQ(lanes.busy(), 0);
  lanes.start(1, job_of(scenario, quick_gains(scenario)));
  EXPECT_EQ(lanes.busy(), 1);
  EXPECT_EQ(lanes.free_lane(), 0);
  Gains of_another_law = quick_gains(scenario);
  change_controller(of_another_law, "joint_pd", scenario.robot->n());
  EXPECT_THROW(lanes.start(lanes.free_lane(), job_of(scenario, of_another_law)), InputError);
  EXPECT_THROW(lanes.start(1, job_of(scenario, quick_gains(scenario))), InputError);
  EXPECT_EQ(lanes.busy(), 1);
}

}  // namespace rollout_lanes_test
}  // namespace armtune::internal
