#include "tuner/first_task/first_task.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "core/control/laws/starting_gains.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/endurance/endurance.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/first_task/first_study.hpp"
#include "tuner/first_task/first_trial.hpp"
#include "tuner/first_task/other_arms.hpp"
#include "tuner/robustness/limits.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace first_task_test {

using test::refused_at;
using testing::HasSubstr;

/// Six joints as vendors publish them: light wrists, and no word about rotors.
std::string light_wrists() {
  RobotModel arm = test::ur10();
  arm.chain.rotor_inertia.setZero();
  return urdf_text(arm);
}

void expect_kept(const Metrics& metrics) {
  EXPECT_LE(metrics[Metric::kJointVelocityMaxRatio], kFirstTaskRatio);
  EXPECT_LE(metrics[Metric::kJointEffortMaxRatio], kFirstTaskRatio);
  EXPECT_GE(metrics[Metric::kJointPositionMinMargin], 0.0);
}

// Tasks take seconds to find: one is looked at from several sides.
TEST(FirstTask, OfAnArmWithoutRotorsIsCompletedWithEstimatedOnesByTheFilesThatAreWritten) {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf", light_wrists());
  const std::string robot = folder.write(
      "arm.yaml",
      "tool: {xyz: [0, 0, 0.1]}\nurdf: arm.urdf   # ours\nviscous_friction: [1, 1, 1, 1, 1, 1]\n");
  const FirstTask found = find_first_task(robot, {}, 2);
  expect_kept(found.metrics);
  EXPECT_EQ(found.robot_file, "robot.yaml");

  const std::string task = folder / "task";
  write_first_task(found, task);
  const Study study = load_study(task + "/study.yaml");
  ASSERT_EQ(study.scenarios.size(), 1U);
  const Scenario& scenario = study.scenarios[0];
  const auto own = load_robot(robot);
  EXPECT_EQ(scenario.robot->chain.p_BT, own->chain.p_BT);
  EXPECT_EQ(scenario.robot->chain.viscous_friction, own->chain.viscous_friction);
  EXPECT_EQ(scenario.robot->estimated_rotors, joint_names(*own));
  const Gains gains = load_gains(task + "/gains.yaml", joint_names(*own));
  for (const double factor : {1.0, 1.0 / 3.0, 3.0}) {
    Scenario other = scenario;
    other.plant.rotor_factors = JointVector::Constant(6, factor);
    const RolloutResult result = Rollout(other, Stepper::kMidpoint).run(gains);
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << factor << ": " << result.reason;
    expect_kept(result.metrics);
  }
}

TEST(FirstTask, OfAnArmWithRotorsNamesTheFileThatWasGivenAndTheDemandThatGainsBreak) {
  const FirstTask found = find_first_task("ur10", {}, 2);
  EXPECT_EQ(found.robot_yaml, "");
  EXPECT_EQ(found.robot_file, "ur10");

  FirstDemands demands(found.task.scenario, found.gains, 2);
  Gains hasty = found.gains;
  hasty.velocity_margin = 0.0;  // nothing slows the reference
  hasty.velocity_barrier_gain = 0.0;
  hasty.slerpDurationErrorGain = 0.05;
  hasty.trajectoryDurationErrorGain = 0.05;
  EXPECT_THAT(demands.broken(hasty), testing::ContainsRegex("in task: sample [0-9]: diverged"));
  Gains wild = found.gains;
  wild.task_space_gains_d *= 100.0;
  EXPECT_THAT(demands.broken(wild), HasSubstr("joint_velocity/max_ratio <= 0.9 is violated"));
}

TEST(FirstTask, ARobotFileThatCannotBeAddedToIsNamed) {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf", light_wrists());
  const std::string robot = folder.write("arm.yaml", "{urdf: arm.urdf, tool: {xyz: [0, 0, 0.1]}}\n");
  EXPECT_THAT(
      [&] { find_first_task(robot, {}); },
      refused_at({.file = robot, .line = 0, .key = "rotor_inertia", .limit = "the key 'rotor_inertia'"}));
}

TEST(FirstTask, RotorsThatAreSaidToBeZeroStayZero) {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf", light_wrists());
  const std::string robot = folder.write("arm.yaml", "urdf: arm.urdf\nrotor_inertia: [0, 0, 0, 0, 0, 0]\n");
  const FirstTask found = find_first_task(robot, {});
  EXPECT_EQ(found.robot_yaml, "");
  EXPECT_TRUE(found.task.scenario.robot->chain.rotor_inertia.isZero(0.0));
  expect_kept(found.metrics);
}

TEST(FirstTask, InTheCellOfARobotFileItsStudyCanBeLoaded) {
  const test::TemporaryFolder folder;
  const std::string robot = folder.write(
      "arm.yaml",
      "urdf: " + test::source_dir() +
          "/sim/robots/panda.urdf\ntip_link: tool0\nrotor_inertia: [0.3, 0.3, 0.3, 0.3, 0.1, 0.1, 0.1]\n"
          "cell: {parts: [{name: wall, box: [0.1, 2, 2], center: [-1, 0, 0]}]}\n");
  const FirstTask found = find_first_task(robot, {});
  write_first_task(found, folder / "task");
  const Study study = load_study(folder / "task/study.yaml");
  ASSERT_TRUE(study.scenarios[0].clearance);
  EXPECT_EQ(study.scenarios[0].clearance->cell().parts.size(), 1U);
  EXPECT_FALSE(study.scenarios[0].clearance->has(Clearance::kFloor)) << "the cell has none";
  TaskOptions floor;
  floor.floor = 0.1;
  EXPECT_THAT([&] { find_first_task(robot, floor); },
              refused_at({.file = robot, .key = "cell", .value = "0.1", .limit = "no --floor"}));
}

// A search that begins with them can then only end with gains that keep them.
TEST(FirstTask, ItsGainsKeepEveryDemandOfItsStudy) {
  const test::TemporaryFolder folder;
  const FirstTask found = find_first_task("youbot", {}, 2);  // whose starting gains break one
  write_first_task(found, folder / "task");
  Study study = load_study(folder / "task/study.yaml");
  CandidateRunner workers(simulated_scenarios(study), study.stepper, 2, study.robust);
  const std::atomic<bool> stop = false;
  Conditions conditions;
  conditions.engine = Engine::kNative;
  auto start = simulate_points(study, {study.space.start_point()}, workers, stop, conditions)->front();
  const Objective objective(study.terms, study.constraints, simulated_scenarios(study), start.results,
                            "youbot");
  objective.judge(start);
  EXPECT_TRUE(start.feasible) << start.violation;
  EXPECT_EQ(FirstDemands(found.task.scenario, found.gains, 1).broken(found.gains), "");
}

// Starting gains keep this arm's limits for one task, and break the effort limit in the first minute.
TEST(FirstTask, ItsGainsHoldForLongAndOnOtherArms) {
  const test::TemporaryFolder folder;
  const RobotModel arm = test::random_arm(6, 1016, false);
  folder.write("arm.urdf", urdf_text(arm));
  const FirstTask found = find_first_task(folder.write("arm.yaml", robot_yaml(arm, "arm.urdf")), {}, 2);
  const std::vector<Scenario> task = {found.task.scenario};
  const std::atomic<bool> stop = false;
  const auto held = [&](const Gains& gains) {
    return endure(
               task, [&gains](const Scenario&) { return gains; }, {}, stop)
        .front()
        .held();
  };
  EXPECT_TRUE(held(found.gains));
  EXPECT_FALSE(held(starting_gains(arm, task[0].start_position, found.task.goal, found.task.manipulability)));
  MonteCarloOptions others;
  others.perturbation = default_perturbation(task);
  others.samples = 100;
  others.engine = Engine::kNative;
  others.workers = 2;
  const auto samples = monte_carlo(task, found.gains, others, stop);
  EXPECT_GE(
      std::count_if(samples.begin(), samples.end(), [](const auto& sample) { return sample.keeps_all(); }),
      95);
}

// Its first joint turns below the floor that an upright arm would stand on.
TEST(FirstTask, AnArmThatCannotStayAboveItsBaseHasNoFloorUnlessItIsGiven) {
  const test::TemporaryFolder folder;
  RobotModel sunk = test::ur10();
  sunk.chain.p_PB0[0] -= Vec3(0.0, 0.0, 3.0);
  const std::string urdf = folder.write("arm.urdf", urdf_text(sunk));
  const std::string robot =
      folder.write("arm.yaml", "urdf: arm.urdf\nrotor_inertia: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\n");
  const FirstTask without = find_first_task(robot, {}, 2);
  EXPECT_TRUE(without.task.without_floor);
  TaskOptions options;
  options.floor = 0.0;
  const InputError error = test::input_error([&] { find_first_task(robot, options, 2); });
  EXPECT_THAT(error, refused_at({.file = testing::StartsWith(folder.path())}));
  EXPECT_THAT(error.what(), HasSubstr("above the floor"));
  options.floor = -3.0;
  EXPECT_FALSE(find_first_task(robot, options, 2).task.without_floor);
}

// Two of its joints slide, one of them by 0.16 m only, and to hold it takes 0.7 of an effort limit.
TEST(FirstTask, AHeavyArmIsHeldByFirmerGainsAtAPlaceThatTakesMoreSearching) {
  TaskOptions options;
  options.mask = TaskMask::kPositionAndAxis;
  const auto robot = std::make_shared<const RobotModel>(test::random_arm(5, 1033, true));
  EXPECT_FALSE(FirstTrial(default_task(robot, options), 2).find());
  options.thorough = true;
  const DefaultTask task = default_task(robot, options);
  const auto found = FirstTrial(task, 2).find();
  ASSERT_TRUE(found);
  EXPECT_TRUE(nearly_all_hold(task.scenario, found->gains, 2));

  // Weaker drives hold the arm as well, but not heavier ones.
  RobotModel weak = *robot;
  for (JointInfo& joint : weak.joints) joint.limits.effort *= 0.8;
  Scenario of_weak = task.scenario;
  of_weak.robot = std::make_shared<const RobotModel>(weak);
  const RolloutResult held = Rollout(of_weak, Stepper::kMidpoint, Engine::kNative).run(found->gains);
  EXPECT_EQ(broken_limit(held, arm_limits(), of_weak).text, "");
  EXPECT_FALSE(nearly_all_hold(of_weak, found->gains, 2));
}

TEST(FirstTask, AnArmThatCanHoldItselfNowhereIsRefusedBeforeAnySearch) {
  RobotModel weak = test::ur10();
  for (JointInfo& joint : weak.joints) joint.limits.effort = 1.0;
  const test::TemporaryFolder folder;
  const std::string urdf = folder.write("arm.urdf", urdf_text(weak));
  int tried = 0;
  const auto progress = [&tried](const std::string&) { ++tried; };
  const InputError error = test::input_error([&] { find_first_task(urdf, {}, 1, progress); });
  EXPECT_EQ(tried, 0);
  EXPECT_THAT(error, refused_at({.file = urdf, .key = "shoulder_lift_joint/effort", .value = "1"}));
}

}  // namespace first_task_test
}  // namespace armtune::internal
