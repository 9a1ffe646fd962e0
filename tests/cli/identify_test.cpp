#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"

namespace armtune::internal {
namespace identify_test {

using test::Finished;
using test::refused_at;
using test::refused_command;
using test::run_program;
using testing::HasSubstr;

TEST(ExciteAndIdentify, LeadFromARobotFileToARunThatStartsFromWhatWasFound) {
  const test::TemporaryFolder folder;
  const std::string excite = folder / "excite";
  const Finished excited =
      run_program({"excite", "ur10", "--center", "0,-90,-60,-90,90,0", "--min-height", "0.1", "--evaluations",
                   "300", "--out", excite, "--scenario", "moving_target"});
  ASSERT_EQ(excited.exit_code, 0) << excited.err;
  EXPECT_THAT(excited.out, HasSubstr("condition number"));
  EXPECT_THAT(excited.out,
              HasSubstr("Smallest distances along the trajectory, computed every 2 ms: between links"));
  EXPECT_THAT(excited.out, HasSubstr("Not checked: contact with the surroundings"));
  for (const char* file : {"excitation.yaml", "trajectory.csv", "log_moving_target.csv", "run.json"}) {
    EXPECT_TRUE(std::filesystem::exists(excite + "/" + file)) << file;
  }

  const std::string found = folder / "found";
  const Finished identified =
      run_program({"identify", "--robot", "ur10", excite + "/log_moving_target.csv", "--out", found});
  ASSERT_EQ(identified.exit_code, 0) << identified.err;
  EXPECT_THAT(identified.out, HasSubstr("52 base parameters"));
  const auto table = test::read_csv(found + "/base_parameters.csv");
  EXPECT_EQ(table.rows.size(), 52U);
  for (const std::string& run : {excite, found}) {
    const RunRecord record = find_run_record(run).value();
    for (const char* file : {"bundled robots/ur10.yaml", "bundled robots/ur10.urdf"})
      EXPECT_NE(test::input_in(record, file).hash, "") << "the robot YAML has figures of the model, too";
  }
  EXPECT_TRUE(find_run_record(excite)->excitation.value().designed);
  const IdentificationFacts facts = find_run_record(found)->identification.value();
  EXPECT_EQ(facts.base_parameters, 52);
  EXPECT_EQ(facts.torque.size(), 6U);
  for (const JointTorqueFact& torque : facts.torque)
    EXPECT_LT(torque.fitted.value(), torque.rms.value()) << torque.joint << ": theta explains the torque";

  // A log with every torque turned leaves nothing behind unless it is asked for.
  const std::string map = folder.write(
      "map.yaml",
      "position: {columns: [joint/shoulder_pan_joint/position, joint/shoulder_lift_joint/position, "
      "joint/elbow_joint/position, joint/wrist_1_joint/position, joint/wrist_2_joint/position, "
      "joint/wrist_3_joint/position]}\n"
      "torque: {columns: [joint/shoulder_pan_joint/torque, joint/shoulder_lift_joint/torque, "
      "joint/elbow_joint/torque, joint/wrist_1_joint/torque, joint/wrist_2_joint/torque, "
      "joint/wrist_3_joint/torque], scale: -1}\n");
  const std::string turned = folder / "turned";
  const Finished doubted = run_program(
      {"identify", "--robot", "ur10", excite + "/log_moving_target.csv", "--columns", map, "--out", turned});
  EXPECT_EQ(doubted.exit_code, 3);
  EXPECT_THAT(doubted.out, testing::AllOf(HasSubstr("wrong sign"), HasSubstr("--accept")));
  EXPECT_FALSE(std::filesystem::exists(turned));
  const Finished accepted = run_program({"identify", "--robot", "ur10", excite + "/log_moving_target.csv",
                                         "--columns", map, "--accept", "--out", turned});
  EXPECT_EQ(accepted.exit_code, 3);
  EXPECT_TRUE(std::filesystem::exists(turned + "/theta.yaml"));
  EXPECT_FALSE(find_run_record(turned)->identification.value().accepted_although.empty());
  EXPECT_THAT(test::read_text(turned + "/theta.yaml"), HasSubstr("wrong sign"));

  // The result is a robot and a start for the controller.
  const Finished robot = run_program({"robot", found + "/robot.yaml"});
  EXPECT_EQ(robot.exit_code, 0) << robot.err;
  EXPECT_THAT(robot.out, HasSubstr("wrist_3_joint"));
  const std::string scenario = folder.write(
      "short.yaml", "base: moving_target\nduration: 12\ntheta_start: {file: found/theta.yaml}\n");
  const Finished simulated = run_program({"simulate", scenario, "--gains", "extended"});
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  const Finished by_option =
      run_program({"simulate", folder.write("plain.yaml", "base: moving_target\nduration: 12\n"), "--gains",
                   "extended", "--theta", found + "/theta.yaml"});
  EXPECT_EQ(by_option.exit_code, 0) << by_option.err;

  const Finished reused = run_program({"excite", "ur10", "--trajectory", excite + "/excitation.yaml", "--out",
                                       folder / "again", "--scenario", "moving_target"});
  EXPECT_EQ(reused.exit_code, 0) << reused.err;
  EXPECT_EQ(test::read_text(folder / "again/log_moving_target.csv"),
            test::read_text(excite + "/log_moving_target.csv"));
}

TEST(ExciteAndIdentify, BadInputEndsWithTwoAndSaysWhatToDo) {
  const test::TemporaryFolder folder;
  const Finished missing = run_program({"identify", "--robot", "ur10", folder / "nowhere.csv"});
  EXPECT_EQ(missing.exit_code, 2);
  const std::string log = folder.write("log.csv", "t,q\n0,1\n1,2\n");
  EXPECT_THAT(refused_command({"identify", "--robot", "ur10", log}),
              refused_at({.file = log, .line = 1, .key = "time"}));
  EXPECT_THAT(refused_command({"excite", "ur10", "--center", "0,0", "--out", folder / "out"}).what(),
              testing::StartsWith("--center has 2 values, but ur10 has 6 joints"));
  EXPECT_THAT(
      refused_command({"excite", "ur10", "--frequency", "5", "--harmonics", "5", "--out", folder / "out"}),
      refused_at({.key = "harmonics", .value = "5", .limit = "at most 20 Hz"}));
  EXPECT_THAT(refused_command({"excite", "ur10", "--duration", "3", "--fade", "2", "--out", folder / "out"}),
              refused_at({.key = "fade", .value = "2", .limit = "at most 1.5 s"}));
  // Of the UR5e's joint names, and another arm.
  EXPECT_THAT(
      refused_command({"excite", "ur5e", "--scenario", "moving_target", "--out", folder / "out"}).what(),
      testing::StartsWith("moving_target: the scenario's robot is ur10, but ROBOT is ur5e"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace identify_test
}  // namespace armtune::internal
