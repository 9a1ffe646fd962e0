// Task files: what is wrong with one, and that one written into a plan's folder is the task that was planned.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {
namespace plan_task_file_test {

using test::refused_at;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

void expect_same(const JointVector& a, const JointVector& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (Eigen::Index i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]) << what;
}

/// Every field but the name and the file, which are those of the file that is read.
void expect_same(const PlanTask& a, const PlanTask& b) {
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(std::filesystem::weakly_canonical(a.scenario.source),
            std::filesystem::weakly_canonical(b.scenario.source));
  EXPECT_EQ(a.at, b.at);
  expect_same(a.start.position, b.start.position, "start position");
  expect_same(a.start.velocity, b.start.velocity, "start velocity");
  expect_same(a.start.acceleration, b.start.acceleration, "start acceleration");
  EXPECT_EQ(a.start.rollout.empty(), b.start.rollout.empty());
  if (!a.start.rollout.empty()) {
    EXPECT_TRUE(std::filesystem::equivalent(a.start.rollout, b.start.rollout));
  }
  expect_same(a.goal, b.goal, "goal");
  EXPECT_EQ(a.duration, b.duration);
  EXPECT_EQ(a.hold, b.hold);
  EXPECT_EQ(a.least_error, b.least_error);
  EXPECT_EQ(a.path_tolerance, b.path_tolerance);
  EXPECT_EQ(a.gaze_threshold, b.gaze_threshold);
  EXPECT_EQ(a.end_gaze, b.end_gaze);
  EXPECT_EQ(a.clearance, b.clearance);
  EXPECT_EQ(a.limits.velocity, b.limits.velocity);
  EXPECT_EQ(a.limits.effort, b.limits.effort);
  expect_same(a.limits.acceleration, b.limits.acceleration, "acceleration limits");
  expect_same(a.limits.jerk, b.limits.jerk, "jerk limits");
  EXPECT_EQ(a.knots, b.knots);
  EXPECT_EQ(a.smoothness, b.smoothness);
}

void expect_written_and_read(const PlanTask& task) {
  const test::TemporaryFolder elsewhere;
  const std::string path = elsewhere.write("task.yaml", plan_task_yaml(task));
  const PlanTask again = load_plan_task(path);
  expect_same(task, again);
  EXPECT_EQ(plan_task_yaml(again), plan_task_yaml(task));
}

TEST(PlanTaskFile, EveryBundledTaskWrittenOutReadsBackTheSame) {
  const std::vector<std::string> names = bundled_names("tasks");
  EXPECT_GE(names.size(), 7U);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    expect_written_and_read(load_plan_task(name));
  }
}

TEST(PlanTaskFile, EveryKeyWrittenOutReadsBackTheSame) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("every.yaml", R"(
description: |-
  it's "quoted": with \ and # and a
  second line
task: move
scenario: obstacle_pass
at: 12.25
start:
  position: [-1.2, -1.4, -1.3, -1.6, 1.5, 0]
  velocity: [0, 0.1, 0, 0, 0, 1e-3]
  acceleration: [0, 0, 0.3, 0, 0, 0]
goal: [1.2, -1.2, -1.4, -1.6, 1.5, 0.1]
duration: 2.5
clearance: 0.3
limits:
  velocity: 0.9
  effort: 0.8
  acceleration: [10, 11, 12, 13, 14, 15]
  jerk: [100, 101, 102, 103, 104, 105]
knots: 77
smoothness: 1e-8
)");
  const PlanTask task = load_plan_task(path);
  EXPECT_EQ(task.description, "it's \"quoted\": with \\ and # and a\nsecond line");
  EXPECT_EQ(task.limits.jerk.size(), 6);
  expect_written_and_read(task);
}

TEST(PlanTaskFile, EveryKeyOfASwitchAndAReturnReadsBackTheSame) {
  const test::TemporaryFolder folder;
  const PlanTask a_switch = load_plan_task(folder.write("switch.yaml", R"(
task: switch
scenario: target_switch
at: 16
hold: 0.7
path_tolerance: 2e-5
gaze_threshold: 0.2
)"));
  EXPECT_EQ(a_switch.hold, 0.7);
  expect_written_and_read(a_switch);
  const PlanTask least = load_plan_task(folder.write("least.yaml", R"(
task: switch
scenario: target_switch
at: 16
least_error: true
duration: 1.5
path_tolerance: 2e-5
)"));
  EXPECT_TRUE(least.least_error);
  expect_written_and_read(least);
  const PlanTask a_return = load_plan_task(folder.write("return.yaml", R"(
task: return
scenario: moving_target
start: {position: [0.1, -1.3, -1.3, -1.8, 1.4, 0]}
end_gaze: true
gaze_threshold: 0.2
)"));
  EXPECT_EQ(a_return.gaze_threshold, 0.2);
  expect_written_and_read(a_return);
}

TEST(PlanTaskFile, ARolloutBesideTheTaskIsFoundFromAnotherFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "it's: a #folder/runs");
  folder.write("it's: a #folder/runs/rollout_moving_target.csv", "time\n");
  const std::string path = folder.write("it's: a #folder/task.yaml",
                                        "task: return\nscenario: moving_target\nat: 10\n"
                                        "start: {rollout: runs/../runs/rollout_moving_target.csv}\n");
  expect_written_and_read(load_plan_task(path));
}

TEST(PlanTaskFile, AScenarioOfItsOwnIsFoundFromAnotherFolder) {
  const test::TemporaryFolder folder;
  folder.write("my: scenario.yaml", "base: moving_target\n");
  const std::string path =
      folder.write("task.yaml", "task: fastest\nscenario: 'my: scenario.yaml'\npath_tolerance: 0.002\n");
  expect_written_and_read(load_plan_task(path));
}

/// Returns the error with which a task of this text is refused. Its file is the task's.
InputError refused(const std::string& text) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("task.yaml", text);
  InputError error = test::input_error([&] { load_plan_task(path); });
  EXPECT_THAT(error, refused_at({.file = path}));
  return error;
}

TEST(PlanTaskFile, SaysWhatIsWrong) {
  EXPECT_THAT(refused("task: jump\nscenario: moving_target\n"),
              refused_at({.line = 1,
                          .key = "task",
                          .value = "jump",
                          .limit = "one of: move, track, switch, return, fastest"}));
  for (const auto& [kind, needed] :
       {std::pair("move", "goal"), std::pair("track", "duration"), std::pair("return", "start")}) {
    EXPECT_THAT(
        refused(std::string("task: ") + kind + "\nscenario: moving_target\n"),
        refused_at(
            {.line = 1, .key = "task", .value = kind, .limit = std::string("the key '") + needed + "'"}));
  }
  EXPECT_THAT(refused("task: switch\nscenario: target_switch\nat: 9\n"),
              refused_at({.line = 3,
                          .key = "at",
                          .value = "9",
                          .limit = StartsWith("one of its switch times: 8, 16, 24, 32")}));
  EXPECT_THAT(refused("task: switch\nscenario: moving_target\nat: 8\n"),
              refused_at({.line = 3, .key = "at", .value = "8", .limit = ""}));
  const std::string fastest = "task: fastest\nscenario: moving_target\n";
  EXPECT_THAT(refused(fastest + "knots: 2\n"),
              refused_at({.line = 3, .key = "knots", .value = "2", .limit = "12 .. 100000"}));
  EXPECT_THAT(refused(fastest + "clearance: 0.3\n"),
              refused_at({.line = 3, .key = "clearance", .value = "0.3", .limit = "0"}));
  EXPECT_THAT(refused(fastest + "limits: {velocity: 2}\n"),
              refused_at({.line = 3, .key = "limits/velocity", .value = "2", .limit = "0.01 to 1"}));
  EXPECT_THAT(refused(fastest + "limits: {jerk: [1, 1, 0, 1, 1, 1]}\n"),
              refused_at({.line = 3, .key = "limits/jerk/2", .value = "0", .limit = "above 0"}));
  const InputError misspelt = refused(fastest + "smothness: 1\n");
  EXPECT_THAT(misspelt, refused_at({.line = 3, .key = "smothness", .value = "smothness"}));
  EXPECT_EQ(test::suggested_by(misspelt), "smoothness");
}

TEST(PlanTaskFile, WhatSaysNothingToATaskIsRefused) {
  EXPECT_THAT(refused("task: fastest\nscenario: moving_target\ngoal: [0, 0, 0, 0, 0, 0]\n"),
              refused_at({.line = 3, .key = "goal"}));
  const InputError hold =
      refused("task: switch\nscenario: target_switch\nat: 8\nleast_error: true\nduration: 1\nhold: 1\n");
  EXPECT_THAT(hold, refused_at({.line = 6, .key = "hold", .value = "1"}));
  EXPECT_THAT(hold.what(), HasSubstr("a switch task with least_error"));
  const InputError threshold = refused(
      "task: return\nscenario: moving_target\nstart: {position: [0, 0, 0, 0, 0, 0]}\n"
      "gaze_threshold: 0.1\n");
  EXPECT_THAT(threshold, refused_at({.line = 4, .key = "gaze_threshold", .value = "0.1"}));
  EXPECT_THAT(threshold.what(), HasSubstr("a return task without end_gaze"));
}

TEST(PlanTaskFile, AStartOrGoalBeyondItsLimitsIsRefusedBeforeAnythingIsSolved) {
  const std::string move = "task: move\nscenario: moving_target\ngoal: ";
  EXPECT_THAT(refused(move + "[0, 0, 4, 0, 0, 0]\n"),
              refused_at({.line = 3, .key = "goal/2", .value = "4", .limit = StartsWith("-3.14")}));
  EXPECT_THAT(refused(move + "{shoulder_pan_joint: 0, shoulder_lift_joint: 0, elbow_joint: 4, "
                             "wrist_1_joint: 0, wrist_2_joint: 0, wrist_3_joint: 0}\n"),
              refused_at({.line = 3, .key = "goal/elbow_joint", .value = "4"}));
  const std::string start = move + "[0, 0, 1, 0, 0, 0]\nstart: {position: [0, 0, 0, 0, 0, 0], ";
  EXPECT_THAT(
      refused(start + "velocity: [0, 0, 0, 0, -4, 0]}\n"),
      refused_at({.line = 4, .key = "start/velocity/4", .value = "-4", .limit = EndsWith(" in size")}));
  EXPECT_THAT(
      refused(start + "acceleration: [9, 0, 0, 0, 0, 0]}\nlimits: {acceleration: [8, 8, 8, 8, 8, 8]}\n"),
      refused_at({.line = 4, .key = "start/acceleration/0", .value = "9", .limit = "at most 8 in size"}));
}

TEST(PlanTaskFile, AnAccelerationLimitAboveTheRobotsIsRefused) {
  const test::TemporaryFolder folder;
  folder.write("arm.yaml", "urdf: " + test::source_dir() +
                               "/sim/robots/ur10.urdf\ntip_link: tool0\nrotor_inertia: estimated\n"
                               "limits: {elbow_joint: {acceleration: 20}}\n");
  folder.write("scenario.yaml", "base: moving_target\nrobot: arm.yaml\n");
  const auto loaded = [&](const std::string& elbow) {
    return load_plan_task(folder.write("task.yaml",
                                       "task: move\nscenario: scenario.yaml\ngoal: [0, 0, 1, 0, 0, 0]\n"
                                       "limits: {acceleration: [90, 90, " +
                                           elbow + ", 90, 90, 90]}\n"));
  };
  EXPECT_EQ(acceleration_limits(loaded("20"))[2], 20.0);
  EXPECT_THAT([&] { loaded("21"); }, refused_at({.file = folder / "task.yaml",
                                                 .line = 4,
                                                 .key = "limits/acceleration/2",
                                                 .value = "21",
                                                 .limit = "at most 20"}));
}

TEST(PlanTaskFile, OnlyGazesArePlanned) {
  const test::TemporaryFolder folder;
  const std::string task = folder.write("task.yaml", "task: track\nscenario: own.yaml\nduration: 2\n");
  folder.write("own.yaml", "base: moving_target\ntargets: []\norientation: {rpy_deg: [180, 0, 90]}\n");
  EXPECT_THAT([&] { load_plan_task(task); }, refused_at({.file = task,
                                                         .line = 2,
                                                         .key = "scenario",
                                                         .value = "own.yaml",
                                                         .limit = "a scenario with gaze targets"}));
  folder.write("own.yaml", "base: moving_target\ntask_mask: position\n");
  EXPECT_THAT([&] { load_plan_task(task); },
              refused_at({.file = task,
                          .line = 2,
                          .key = "scenario",
                          .value = "own.yaml",
                          .limit = "a scenario that controls more than the tool position"}));
  folder.write("own.yaml", "base: moving_target\ntask_mask: position_and_axis\n");
  EXPECT_NO_THROW(load_plan_task(task));
}

}  // namespace plan_task_file_test
}  // namespace armtune::internal
