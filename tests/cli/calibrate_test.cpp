#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "sim/scenario/robot_file.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/calibration/hidden_log.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace calibrate_test {

using test::Finished;
using test::HiddenArm;
using test::refused_at;
using test::refused_command;
using test::run_program;
using testing::HasSubstr;

/// Returns the words of a text, separated by one blank.
std::string unwrapped(const std::string& text) {
  std::istringstream words(text);
  std::string out;
  for (std::string word; words >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

TEST(Calibrate, EndsWithTheResultAsASentenceAndWritesItsFiles) {
  const test::TemporaryFolder files;
  const HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 11, 125.0);
  const std::string log =
      files.write("log.csv", test::hidden_log_text(arm.model, test::short_torque_log(arm, 6.0)));
  const Finished done = run_program({"calibrate", log, "--robot", "ur5e", "--out", files / "run"});
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
  const CalibrationFacts facts = find_run_record(files / "run")->calibration.value();
  EXPECT_TRUE(facts.better);
  const std::string out = unwrapped(done.out);
  EXPECT_TRUE(out.ends_with(unwrapped(facts.headline) + ".")) << done.out;
  for (const UntoldFact& untold : facts.not_told)
    EXPECT_THAT(out, HasSubstr(untold.parameter.substr(untold.parameter.rfind('/') + 1)));
  for (const char* file : {"robot.yaml", "robot.urdf", "uncertainty.yaml", "parameters.csv", "held_out.csv"})
    EXPECT_TRUE(std::filesystem::exists(files / (std::string("run/") + file))) << file;
  std::istringstream lines(done.out);
  std::string line;
  std::getline(lines, line);  // names the file
  while (std::getline(lines, line)) {
    const std::size_t most = line.starts_with("wrote ") ? line.size() : 80U;
    EXPECT_LE(line.size(), most) << line;
  }

  EXPECT_EQ(run_program({"robot", files / "run/robot.yaml"}).exit_code, 0);
  EXPECT_THAT(refused_command({"calibrate", log, "--robot", "ur5e", "--out", files / "run"}),
              refused_at({.file = files / "run"}));
}

TEST(Calibrate, RefusesLogsWithoutCommandsOrJointsAndBriefOnes) {
  const test::TemporaryFolder files;
  const HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 11, 125.0);
  const CommandedLog made = test::short_torque_log(arm, 1.0);
  const std::string bare = files.write("bare.csv", test::hidden_log_text(arm.model, made, false));
  EXPECT_THAT(refused_command({"calibrate", bare, "--robot", "ur5e", "--out", files / "run"}),
              refused_at({.file = bare, .key = "--commands", .value = "none"}));
  EXPECT_FALSE(std::filesystem::exists(files / "run"));
  EXPECT_THAT(refused_command({"calibrate", bare, "--robot", "ur5e", "--commands", "position"}),
              refused_at({.file = bare, .key = "--commands", .value = "position"}));
  const std::string brief = files.write("brief.csv", test::hidden_log_text(arm.model, made));
  EXPECT_THAT(refused_command({"calibrate", brief, "--robot", "ur5e"}),
              refused_at({.file = brief, .key = "time"}));
  EXPECT_THAT(refused_command({"calibrate", brief, "--robot", "panda"}),
              refused_at({.file = brief, .key = "position"}));
  const std::string other = files.write("other.csv", "time,temperature\n0,1\n0.1,2\n0.2,3\n");
  EXPECT_THAT(refused_command({"calibrate", other, "--robot", "ur5e"}), refused_at({.file = other}));
}

}  // namespace calibrate_test
}  // namespace armtune::internal
