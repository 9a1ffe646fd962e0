#include "sim/scenario/default_task.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/control/laws/starting_gains.hpp"
#include "core/robot/holding_load.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/default_task_file.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace default_task_test {

void does_its_task(const std::shared_ptr<const RobotModel>& robot) {
  const DefaultTask task = default_task(robot);
  const Gains gains = starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability);
  const double radius = task.scenario.path.terms[0].cosine.norm();
  const RolloutResult result = Rollout(task.scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_GT(result.metrics[Metric::kSamples], 5000.0);
  EXPECT_LT(result.metrics[Metric::kPositionMax], 0.2 * radius);
  EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], 1.0);
  if (tracks_orientation(task.scenario.mask)) {
    EXPECT_LT(result.metrics[Metric::kOrientationMax], 0.05);
  }
}

class BundledRobots : public testing::TestWithParam<const char*> {};

TEST_P(BundledRobots, DoTheirFirstTaskWithTheirStartingGains) {
  does_its_task(load_robot(GetParam()));
}

TEST_P(BundledRobots, FirstTaskReadsBackAsItIs) {
  const auto robot = load_robot(GetParam());
  const DefaultTask task = default_task(robot);
  const test::TemporaryFolder folder;
  const Scenario back = load_scenario(folder.write("task.yaml", default_task_yaml(task, GetParam())));
  EXPECT_EQ(back.path.center, task.scenario.path.center);
  EXPECT_EQ(back.path.terms[0].cosine, task.scenario.path.terms[0].cosine);
  EXPECT_EQ(back.path.terms[0].sine, task.scenario.path.terms[0].sine);
  EXPECT_EQ(back.path.frequency, task.scenario.path.frequency);
  EXPECT_LT((back.start_position - task.scenario.start_position).norm(), 1e-2);  // four digits of degrees
  EXPECT_EQ(back.mask, task.scenario.mask);
  ASSERT_EQ(back.targets.size(), 2U);
  EXPECT_EQ(back.targets[1].path.center, task.scenario.targets[1].path.center);
  EXPECT_EQ(back.switch_every, task.scenario.switch_every);
  EXPECT_NEAR(back.plant.payload.mass, task.scenario.plant.payload.mass, 1e-9);
  EXPECT_EQ(back.plant.velocity_noise, task.scenario.plant.velocity_noise);
}

TEST_P(BundledRobots, FirstTaskKnowsTheSmallestManipulabilityOnItsWay) {
  const DefaultTask task = default_task(load_robot(GetParam()));
  const PathWalk walk = walk_path(task.scenario, task.goal, 0.2);  // centred as its starting gains do
  EXPECT_GT(task.manipulability, 0.0);
  EXPECT_EQ(task.manipulability, walk.manipulability.value);
}

constexpr std::array kBundled{"fr3",  "gen3_6", "gen3_7", "iiwa14", "panda", "ur10",
                              "ur3e", "ur5e",   "xarm6",  "xarm7",  "youbot"};

INSTANTIATE_TEST_SUITE_P(Robots, BundledRobots, testing::ValuesIn(kBundled));

TEST(DefaultTask, IsTriedOnEveryBundledRobot) {
  EXPECT_THAT(bundled_names("robots"), testing::UnorderedElementsAreArray(kBundled));
}

TEST(DefaultTask, KeepsAboveTheFloorThatIsGiven) {
  // A floor above the shoulder, of an arm whose links have no shapes that would be in it.
  RobotModel bare = *load_robot("ur10");
  bare.shapes.clear();
  const auto robot = std::make_shared<const RobotModel>(bare);
  TaskOptions options;
  options.floor = 0.6;
  const DefaultTask task = default_task(robot, options);
  EXPECT_GE(walk_path(task.scenario, task.goal, 0.2).low.value, 0.7);
  EXPECT_GE(height_of(task.scenario.targets[0].path.center, *robot), 0.6 - 1e-3);
  options.floor = 5.0;
  const InputError error = test::input_error([&] { default_task(robot, options); });
  EXPECT_THAT(error, test::refused_at({.file = robot->source}));
  EXPECT_THAT(error.what(), testing::HasSubstr("--floor"));
}

// Nothing but the place changes with the place where the arm stands.
TEST(DefaultTask, IsTheSameWhereverTheArmStands) {
  const auto robot = load_robot("ur10");
  RobotModel moved = *robot;
  moved.chain.p_PB0[0] += Vec3(4.0, -2.0, 1.0);
  for (Shape& shape : moved.shapes) {
    if (shape.body < 0) shape.p_BS += Vec3(4.0, -2.0, 1.0);
  }
  TaskOptions options;
  options.floor = 1.0;
  const DefaultTask here = default_task(robot);
  const DefaultTask there = default_task(std::make_shared<const RobotModel>(moved), options);
  EXPECT_EQ(there.goal.size(), here.goal.size());
  EXPECT_LT((there.goal - here.goal).norm(), 1e-6);
  EXPECT_LT((there.scenario.path.center - here.scenario.path.center - Vec3(4.0, -2.0, 1.0)).norm(), 1e-9);
}

TEST(DefaultTask, AnArmThatHangsHasNoFloorUnlessItIsGiven) {
  RobotModel hanging = *load_robot("ur10");
  hanging.chain.gravity = -hanging.chain.gravity;
  const auto robot = std::make_shared<const RobotModel>(hanging);
  const DefaultTask task = default_task(robot);
  EXPECT_LT(height_of(task.scenario.path.center, *robot), 0.0);
}

TEST(DefaultTask, ATableInTheWayIsAvoidedOrNamed) {
  const auto table = [](double side, const Vec3& center) {
    TaskOptions options;
    options.cell = Cell{};
    Path rests;
    rests.center = center;
    options.cell->parts.push_back({"table", box({side, side, 0.05}), Mat3::Identity(), rests});
    return options;
  };
  const auto arm = load_robot("ur5e");
  const DefaultTask free = default_task(arm, {});
  // A plate across the circle that it would take without one.
  const Vec3 center = free.scenario.path.center;
  const DefaultTask beside = default_task(arm, table(0.3, center));
  const auto nearest = [](const Scenario& scenario, const JointVector& goal) {
    double least = 1.0;
    for (const LeastClearance& found : walk_path(scenario, goal, 0.2).nearest)
      least = std::min(least, found.pair == nullptr ? 1.0 : found.distance);
    return least;
  };
  EXPECT_GT(nearest(beside.scenario, beside.goal), 0.0);
  Scenario crossing = free.scenario;
  crossing.clearance = beside.scenario.clearance;
  EXPECT_LT(nearest(crossing, free.goal), 0.0) << "the plate is in the way";
  // One that the arm stands in, above a floor: it leaves no place.
  TaskOptions through = table(3.0, Vec3(0.0, 0.0, 0.35));
  through.cell->floor = 0.0;
  EXPECT_THAT(
      test::refusal([&] { default_task(arm, through); }),
      testing::AllOf(testing::HasSubstr("no first task was found"), testing::HasSubstr("and table touch")));
}

// The two first links are always close to the floor, and must not hide others that are.
TEST(DefaultTask, NoLinkBeyondTheSecondComesCloserToItsSurroundingsThanFiveCentimetres) {
  for (const char* name : {"ur5e", "ur10", "fr3"}) {
    TaskOptions options;
    options.cell = Cell{};
    options.cell->floor = 0.0;
    const DefaultTask task = default_task(load_robot(name), options);
    const ClearanceModel& model = *task.scenario.clearance;
    const std::vector<double> required(model.pairs().size(), 0.05);
    const PathWalk walk = walk_path(task.scenario, task.goal, 0.2, 0.0, WalkUntil::kEnd, required);
    for (const LeastClearance& near : walk.too_near) {
      const bool may = near.pair->of == Clearance::kSelf || model.arm().solids[near.pair->solid].body <= 1;
      EXPECT_TRUE(may) << name << ": " << model.name(*near.pair) << ' ' << near.distance;
    }
  }
}

TEST(DefaultTask, AnArmThatCanHoldItselfNowhereIsRefused) {
  RobotModel weak = *load_robot("ur10");
  for (JointInfo& joint : weak.joints) joint.limits.effort = 1.0;
  EXPECT_THAT(test::input_error([&] { default_task(std::make_shared<const RobotModel>(weak)); }),
              test::refused_at({.file = weak.source, .key = "shoulder_lift_joint/effort", .value = "1"}));
}

// It can hold itself at some positions, but on no circle. Its second joint slides.
TEST(DefaultTask, WhereEveryTaskIsTooHeavyTheForceAndTheLimitOfAJointAreSaid) {
  RobotModel heavy = test::random_arm(6, 1007, true);
  for (JointInfo& joint : heavy.joints) joint.limits.effort *= 0.9;
  const std::string text = test::refusal([&] { default_task(std::make_shared<const RobotModel>(heavy)); });
  const std::string joint = heavy.joints[1].name;
  const auto at = text.find("joint '" + joint + "' needs ");
  ASSERT_NE(at, std::string::npos) << text;
  double needs = 0.0, limit = 0.0;
  EXPECT_EQ(std::sscanf(text.c_str() + at, ("joint '" + joint + "' needs %lf N ").c_str(), &needs), 1);
  const auto behind = text.find("effort limit is ");
  ASSERT_NE(behind, std::string::npos) << text;
  EXPECT_EQ(std::sscanf(text.c_str() + behind, "effort limit is %lf N.", &limit), 1);
  EXPECT_NEAR(limit, heavy.joints[1].limits.effort, 0.01 * limit);  // three digits
  EXPECT_GT(needs, 0.85 * limit);
}

// Of its tasks, the first would begin where a joint cannot hold the arm.
TEST(DefaultTask, TheWayFromTheStartBurdensNoJointMoreThanTheTaskOrHalfOfItsLimit) {
  for (const unsigned seed : {1016U, 1029U, 1033U}) {
    const auto robot = std::make_shared<const RobotModel>(
        test::random_arm(5 + static_cast<int>((seed - 1000) % 3), seed, seed % 2 == 1));
    TaskOptions options;
    options.without_floor = true;
    for (const DefaultTask& task : default_tasks(robot, options, 3)) {
      const Chain loaded = with_payload(*robot, task.scenario.plant.payload).chain;
      const JointVector away = task.scenario.start_position - task.goal;
      const JointVector whole = off_goal(*robot, task.goal) - task.goal;
      const double closer = away.norm() / whole.norm();
      EXPECT_LT((away - closer * whole).norm(), 1e-12);
      EXPECT_GE(closer, 1.0 / 32.0 - 1e-12);
      if (closer < 1.0 / 31.0) continue;
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const JointVector q = task.goal + share * away;
        EXPECT_LE(holding_load(loaded, q, robot->effort_limits()).share, std::max(task.load, 0.5)) << seed;
      }
      const HoldingLoad there = holding_load(loaded, task.goal, robot->effort_limits());
      EXPECT_GE(task.load, there.share - 1e-6) << seed;
    }
  }
}

TEST(DefaultTask, AnArmThatHoldsItselfEasilyStartsAtAWholeDistance) {
  bool heavier = false;
  for (const unsigned seed : {1000U, 1004U, 1010U}) {
    const RobotModel arm = test::random_arm(5 + static_cast<int>((seed - 1000) % 3), seed, false);
    TaskOptions options;
    options.without_floor = true;
    const DefaultTask task = default_task(std::make_shared<const RobotModel>(arm), options);
    const JointVector& start = task.scenario.start_position;
    const double load = holding_load(arm.chain, start, arm.effort_limits()).share;
    ASSERT_LT(load, 0.45) << seed;
    heavier = heavier || load > task.load;
    EXPECT_LT((start - off_goal(arm, task.goal)).norm(), 1e-12) << seed;
  }
  EXPECT_TRUE(heavier) << "the start takes more than the task on none of them";
}

// Its last joint slides by 0.16 m, its second bears most of the arm.
TEST(DefaultTask, MorePositionsGiveAHeavyArmMorePlaces) {
  const auto robot = std::make_shared<const RobotModel>(test::random_arm(5, 1033, true));
  TaskOptions options;
  options.mask = TaskMask::kPositionAndAxis;
  EXPECT_EQ(default_tasks(robot, options, 6).size(), 1U);
  options.thorough = true;
  EXPECT_EQ(default_tasks(robot, options, 6).size(), 6U);
}

TEST(DefaultTask, ASlowArmIsGivenMoreTimeForTwoTurnsAndThreeLooks) {
  const auto robot = load_robot("ur10");
  TaskOptions options;
  options.slowness = 2.0;
  const Scenario whole = default_task(robot).scenario;
  const Scenario slow = default_task(robot, options).scenario;
  EXPECT_EQ(whole.duration, 30.0);
  EXPECT_EQ(slow.duration, 45.0);
  EXPECT_GE(slow.duration, 2.0 * slow.path.period() * (1.0 - 1e-12));
  EXPECT_GE(slow.duration, 3.0 * slow.switch_every);
  EXPECT_EQ(slow.switch_every, 2.0 * whole.switch_every);
  EXPECT_EQ(slow.path.frequency, 0.5 * whole.path.frequency);
}

TEST(DefaultTask, ThereAreOthersAtOtherPlaces) {
  const auto robot = load_robot("ur10");
  const std::vector<DefaultTask> tasks = default_tasks(robot, {}, 3);
  ASSERT_EQ(tasks.size(), 3U);
  EXPECT_EQ(tasks[0].goal, default_task(robot).goal);
  for (std::size_t i = 1; i < tasks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((tasks[i].scenario.path.center - tasks[j].scenario.path.center).norm(), 1e-3);
    EXPECT_TRUE(is_clear(walk_path(tasks[i].scenario, tasks[i].goal, 0.2)));
  }
}

TEST(DefaultTask, ATaskOfPositionAloneLooksAtNothing) {
  TaskOptions options;
  options.mask = TaskMask::kPosition;
  EXPECT_EQ(default_task(load_robot("ur10"), options).scenario.mask, TaskMask::kPosition);
}

TEST(DefaultTask, WithoutAFloorItSaysSo) {
  TaskOptions options;
  options.without_floor = true;
  const DefaultTask task = default_task(load_robot("ur10"), options);
  EXPECT_FALSE(task.scenario.clearance->has(Clearance::kFloor));
  EXPECT_THAT(default_task_yaml(task, "ur10"), testing::HasSubstr("# There is no floor"));
}

TEST(DefaultTask, ARobotsNameMayLookLikeYaml) {
  RobotModel named = *load_robot("ur10");
  named.name = "arm: v2 #1";
  const DefaultTask task = default_task(std::make_shared<const RobotModel>(named));
  const test::TemporaryFolder folder;
  const Scenario back = load_scenario(folder.write("task.yaml", default_task_yaml(task, "ur10")));
  EXPECT_NE(back.description.find("that arm: v2 #1 follows far"), std::string::npos) << back.description;
}

TEST(DefaultTask, AnArmOfThreeJointsHoldsItsPositionOnly) {
  const DefaultTask task = default_task(std::make_shared<const RobotModel>(test::random_arm(3, 5, false)));
  EXPECT_EQ(task.scenario.mask, TaskMask::kPosition);
  EXPECT_EQ(default_task_yaml(task, "arm.yaml").find("gaze"), std::string::npos);
}

TEST(DefaultTask, TwoJointsAreTooFewToHaveAToolAnywhere) {
  const auto arm = std::make_shared<const RobotModel>(test::random_arm(2, 5, false));
  EXPECT_THAT(test::refusal([&] { default_task(arm); }), testing::HasSubstr("2 joints are too few"));
}

}  // namespace default_task_test
}  // namespace armtune::internal
