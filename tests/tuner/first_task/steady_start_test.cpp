#include "tuner/first_task/steady_start.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace steady_start_test {

using testing::HasSubstr;

const std::string kParameters =
    "parameters:\n  - {name: task_space_gains_p/rx}\n  - {name: slerpDurationErrorGain}\n";

/// Scenarios long enough for gains that nobody has tuned.
class LongerStudy : public test::ShortStudy {
 public:
  explicit LongerStudy(const std::string& parameters) : ShortStudy(parameters) {
    write("short.yaml", "base: moving_target\nduration: 20\n");
    write("short_realistic.yaml", "base: realistic_moving_target\nduration: 20\n");
  }
};

/// Kp beyond the rate at which S dies: the wrist runs away.
Gains ringing() {
  Gains gains = test::quick_gains(test::scenario_of("moving_target"));
  gains.task_space_gains_p *= 100.0;
  return gains;
}

TEST(SteadyStart, IsTheStudyItselfWhereItsStartCompletesEveryScenario) {
  const LongerStudy files(kParameters);
  const Study study = load_steady_study(files.path(), "", 2);
  const Study as_read = load_study(files.path());
  EXPECT_FALSE(study.given);
  EXPECT_EQ(gains_yaml(study.space.start, {}), gains_yaml(as_read.space.start, {}));
}

TEST(SteadyStart, TakesThePlaceOfGainsThatRing) {
  const LongerStudy files(kParameters);
  const Gains bad = ringing();
  files.write("gains.yaml", gains_yaml(bad, {}));
  const Study study = load_steady_study(files.path(), "", 2);
  ASSERT_TRUE(study.given);
  EXPECT_EQ(study.given->task_space_gains_p, bad.task_space_gains_p);
  EXPECT_THAT(study.given_failure, HasSubstr("short"));
  EXPECT_EQ(study.gains, files / "gains.yaml") << "it is an input still";
  for (const Scenario& scenario : study.scenarios) {
    const RolloutResult result =
        Rollout(scenario, study.stepper, Engine::kSimbody).run(with_goal(study.space.start, scenario));
    EXPECT_EQ(result.status, RolloutStatus::kCompleted) << scenario.name << ": " << result.reason;
    EXPECT_LE(result.metrics[Metric::kJointVelocityMaxRatio], 1.0);
  }
  // Bounds that follow the start follow the new one.
  const Parameter& free = study.space.free[1];
  EXPECT_EQ(free.start, study.space.start.slerpDurationErrorGain);
  EXPECT_LT(free.lower, free.start);
  EXPECT_GT(free.upper, free.start);
}

TEST(SteadyStart, IsOfTheControllerThatTheFileAsksFor) {
  const LongerStudy files(kParameters);
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  const Study study = load_steady_study(files.path(), "computed_torque", 2);
  EXPECT_EQ(study.space.start.controller, "computed_torque");
}

TEST(SteadyStart, BoundsThatLeaveItOutAreNamed) {
  const LongerStudy files(
      "parameters:\n  - {name: task_space_gains_p/x, lower: 500, upper: 100000}\n"
      "  - {name: slerpDurationErrorGain}\n");
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  EXPECT_THAT([&] { load_steady_study(files.path(), "", 2); },
              test::refused_at({.file = files.path(),
                                .key = "task_space_gains_p/x",
                                .value = testing::Not(testing::IsEmpty()),
                                .limit = "500 to 100000"}));
}

/// The study of examples/joint_trajectory with another parameter file.
std::string study_of(const test::TemporaryFolder& folder, const std::string& from, const std::string& to,
                     const std::string& parameters) {
  const std::string example = test::source_dir() + "/examples/joint_trajectory/";
  std::string gains = test::read_text(example + "ros2_controllers.yaml");
  const auto at = gains.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  folder.write("gains.yaml", gains.replace(at, from.size(), to));
  return folder.write("study.yaml",
                      "{gains: gains.yaml, scenarios: [" + example +
                          "moves.yaml], objective: [{metric: joint_error/rms, weight: 1}], parameters: [" +
                          parameters + "]}\n");
}

// Such gains complete the motion; nothing tuned from a fifth to five times their values would hold still.
TEST(SteadyStart, TakesThePlaceOfGainsThatShake) {
  const test::TemporaryFolder folder;
  const std::string path = study_of(folder, "wrist_1_joint: {p: 300.0, d: 10.0",
                                    "wrist_1_joint: {p: 3000.0, d: 1.0", "{name: jtc_p}, {name: jtc_d}");
  const Study study = load_steady_study(path, "", 2);
  ASSERT_TRUE(study.given);
  EXPECT_EQ(own(*study.given, "jtc_p")[3], 3000.0);
  EXPECT_THAT(study.given_failure, HasSubstr("wrist_1_joint shakes"));
  EXPECT_LT(own(study.space.start, "jtc_p")[3] / own(study.space.start, "jtc_d")[3], 100.0) << "of 3000";
}

TEST(SteadyStart, LeavesAtZeroWhatTheFileHasAtZeroAndTheStudyDoesNotTune) {
  const test::TemporaryFolder folder;
  const std::string path = study_of(folder, "wrist_1_joint: {p: 300.0, d: 10.0, i: 50.0",
                                    "wrist_1_joint: {p: 3000.0, d: 1.0, i: 0.0",
                                    "{name: jtc_p}, {name: jtc_d}, {name: jtc_i/elbow_joint}");
  const Study study = load_steady_study(path, "", 2);
  ASSERT_TRUE(study.given);
  EXPECT_EQ(own(study.space.start, "jtc_i")[3], 0.0);
  EXPECT_GT(own(study.space.start, "jtc_i")[2], 0.0);
}

// The file's clamp stays, so a computed i that needs a larger one would only wind up.
TEST(SteadyStart, ComputesAnIntegralThatItsClampLetsAct) {
  const test::TemporaryFolder folder;
  const std::string path = study_of(folder, "wrist_1_joint: {p: 300.0, d: 10.0, i: 50.0, i_clamp: 20.0",
                                    "wrist_1_joint: {p: 3000.0, d: 1.0, i: 1.0, i_clamp: 1.0",
                                    "{name: jtc_p}, {name: jtc_d}, {name: jtc_i}");
  const Study study = load_steady_study(path, "", 2);
  ASSERT_TRUE(study.given);
  const Gains& start = study.space.start;
  EXPECT_EQ(own(start, "jtc_i_clamp")[3], 1.0);
  const JointVector effort = study.scenarios.front().robot->effort_limits();
  for (int k = 0; k < 6; ++k) {
    const double after_a_second = own(start, "jtc_i")[k] * effort[k] / own(start, "jtc_p")[k];
    EXPECT_GT(own(start, "jtc_i")[k], 0.0) << k;
    EXPECT_LE(after_a_second, own(start, "jtc_i_clamp")[k] * (1.0 + 1e-12)) << k;
  }
}

// A stiffness that the damping cannot hold in a sampled loop of period T: P T > 2 D.
TEST(SteadyStart, TakesThePlaceOfAnUnstableJointPd) {
  const test::TemporaryFolder folder;
  const auto robot = load_robot("ur10");
  const DefaultTask task = default_task(robot);
  folder.write("task.yaml", default_task_yaml(task, "ur10"));
  Gains bad =
      convert_gains(controller_kind("joint_pd"),
                    starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability),
                    *robot, task.goal);
  own(bad, "joint_pd_p") *= 100.0;
  own(bad, "joint_pd_d") *= 0.01;
  folder.write("gains.yaml", gains_yaml(bad, {}));
  const std::string path = folder.write(
      "study.yaml",
      "{gains: gains.yaml, scenarios: [task.yaml], objective: [{metric: error/position/max, weight: 1}], "
      "parameters: [{name: joint_pd_p}, {name: joint_pd_d}]}\n");
  const Study study = load_steady_study(path, "", 2);
  ASSERT_TRUE(study.given);
  EXPECT_EQ(own(*study.given, "joint_pd_p"), own(bad, "joint_pd_p"));
  EXPECT_THAT(study.given_failure, HasSubstr("task"));
  EXPECT_EQ(study.space.start.controller, "joint_pd");
  EXPECT_LT(own(study.space.start, "joint_pd_p")[0], own(bad, "joint_pd_p")[0]);
  const Scenario& scenario = study.scenarios[0];
  const RolloutResult result =
      Rollout(scenario, study.stepper, Engine::kNative).run(with_goal(study.space.start, scenario));
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LE(result.metrics[Metric::kJointVelocityMaxRatio], 1.0);
}

// The file's gains can be tuned as they are, although first gains would not fit the study.
TEST(SteadyStart, GainsThatShakeAreLeftWhereFirstGainsDoNotFitTheBounds) {
  const test::TemporaryFolder folder;
  const std::string path =
      study_of(folder, "wrist_1_joint: {p: 300.0, d: 10.0", "wrist_1_joint: {p: 3000.0, d: 1.0",
               "{name: jtc_p/wrist_1_joint, lower: 2900, upper: 3100}");
  EXPECT_FALSE(load_steady_study(path, "", 2).given);
}

// Then the start is simulated as the file says, and the error is that of any study.
TEST(SteadyStart, AStudyWithStartsOfItsOwnThatRingIsLeftAsItIs) {
  const LongerStudy files(
      "parameters:\n"
      "  - {name: task_space_gains_p, start: 3000}\n"
      "  - {name: slerpDurationErrorGain}\n");
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  EXPECT_FALSE(load_steady_study(files.path(), "", 2).given);
}

}  // namespace steady_start_test
}  // namespace armtune::internal
