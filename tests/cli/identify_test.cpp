#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"

namespace armtune::internal {
namespace identify_test {

using test::Finished;
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
  const Finished columns =
      run_program({"identify", "--robot", "ur10", folder.write("log.csv", "t,q\n0,1\n1,2\n")});
  EXPECT_EQ(columns.exit_code, 2);
  EXPECT_THAT(columns.err, HasSubstr("'time'"));
  const Finished center = run_program({"excite", "ur10", "--center", "0,0", "--out", folder / "out"});
  EXPECT_EQ(center.exit_code, 2);
  EXPECT_THAT(center.err, HasSubstr("6 joints"));
  const Finished fast =
      run_program({"excite", "ur10", "--frequency", "5", "--harmonics", "5", "--out", folder / "out"});
  EXPECT_EQ(fast.exit_code, 2);
  EXPECT_THAT(fast.err, HasSubstr("must not exceed 20 Hz"));
  const Finished fades =
      run_program({"excite", "ur10", "--duration", "3", "--fade", "2", "--out", folder / "out"});
  EXPECT_EQ(fades.exit_code, 2);
  EXPECT_THAT(fades.err, HasSubstr("2 s each do not fit in a duration of 3 s"));
  // Of the UR5e's joint names, and another arm.
  const Finished other =
      run_program({"excite", "ur5e", "--scenario", "moving_target", "--out", folder / "out"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, testing::AllOf(HasSubstr("ur10"), HasSubstr("ur5e")));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace identify_test
}  // namespace armtune::internal
