// Gains on their way to a robot: armtune export, and armtune compare --gains.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace export_test {

using test::Finished;
using test::refused_at;
using test::refused_command;
using test::run_program;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class ExportCommand : public testing::Test {
 protected:
  const test::ShortStudy files_;
  const std::vector<std::string> joints_ = joint_names(*test::scenario_of("moving_target").robot);
};

TEST_F(ExportCommand, OfATunedRunSaysWhereItsGainsCameFromAndReadsBackToTheBit) {
  const std::string run = files_ / "run";
  ASSERT_EQ(run_program({"tune", files_.path(), "--out", run, "--workers", "1"}).exit_code, 0);
  const std::string written = gains_yaml(load_gains(run + "/gains.yaml", joints_), {});
  for (const char* format : {"yaml", "ros1", "ros2"}) {
    const std::string file = files_ / (std::string(format) + ".yaml");
    const Finished done = run_program({"export", run, "--format", format, "--out", file});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.out, "wrote " + file + "\n");
    EXPECT_EQ(gains_yaml(load_gains(file, joints_), {}), written);
    EXPECT_THAT(test::read_text(file),
                AllOf(HasSubstr("# study: "), HasSubstr("# seed: 1\n"), HasSubstr("# command: armtune tune"),
                      HasSubstr("# simulation checks: passed\n"),
                      ContainsRegex("# joint_velocity/max_ratio: 0\\.[0-9]+ in short"),
                      ContainsRegex("# input bundled robots/ur10.urdf: fnv1a-[0-9a-f]+\n")));
  }
  std::string verdict = test::read_text(run + "/verdict.yaml");
  EXPECT_EQ(run_program({"export", run}).err, "");
  std::ofstream(run + "/verdict.yaml")
      << std::string(verdict).replace(verdict.find(", passed: true"), 14, ", passed: false");
  EXPECT_THAT(run_program({"export", run}).err,
              HasSubstr("in simulation these gains failed: constraints. Do not"));
  EXPECT_EQ(run_program({"export", run + "/start"}).err, "") << "the checks were those of other gains";
  // Other gains of the run are of its arm, but its figures are not theirs; nor are they once gains.yaml is
  // changed, or the arm is another.
  const auto without_figures = [](const std::vector<std::string>& arguments, const std::string& why) {
    const Finished done = run_program(arguments);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_THAT(done.out, AllOf(HasSubstr("# warning: "), HasSubstr(why), HasSubstr("# study: "),
                                testing::Not(HasSubstr("# joint_velocity/max_ratio")),
                                testing::Not(HasSubstr("# objective"))));
  };
  without_figures({"export", run + "/start"},
                  "not apply to these gains, which are not those of its gains.yaml");
  std::string urdf = test::read_text(test::source_dir() + "/sim/robots/ur10.urdf");
  urdf.replace(urdf.find("<mass value=\""), 13, "<mass value=\"1");
  without_figures({"export", run, "--robot", files_.write("heavier.urdf", urdf)},
                  "not apply to these gains on this arm");
  std::string gains = test::read_text(run + "/gains.yaml");
  gains.replace(gains.find("slerpDurationErrorGain: "), 24, "slerpDurationErrorGain: 1");
  std::ofstream(run + "/gains.yaml") << gains;
  without_figures({"export", run}, "was changed after the run");
  // Nothing there is written over.
  const Finished again = run_program({"export", run, "--out", files_ / "ros1.yaml"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
}

TEST_F(ExportCommand, WritesToTheScreenAndForOtherArms) {
  const Finished ros2 =
      run_program({"export", "published", "--format", "ros2", "--node", "/ur10/effort_ctrl"});
  EXPECT_EQ(ros2.exit_code, 0) << ros2.err;
  EXPECT_THAT(ros2.out, AllOf(testing::StartsWith("# gains: bundled gains/published.yaml, for ur10"),
                              HasSubstr("\n/ur10/effort_ctrl:\n  ros__parameters:\n"),
                              HasSubstr("task_space_gains_p: [80.0, 50.0, 50.0, 25.0, 15.0, 3.0]\n")));
  const Finished panda = run_program({"export", "panda", "--robot", "panda"});
  EXPECT_EQ(panda.exit_code, 0) << panda.err;
  EXPECT_THAT(panda.out, AllOf(HasSubstr("for panda"), HasSubstr("panda_joint7")));
}

TEST_F(ExportCommand, SaysWhatIsWrong) {
  EXPECT_THAT(refused_command({"export", "publishd"}),
              refused_at({.value = "publishd", .suggestion = "published"}));
  EXPECT_THAT(refused_command({"export", "panda"}).what(), testing::EndsWith("--robot"))
      << "the UR10 has six joints";
  std::string gains = test::read_text(files_ / "gains.yaml");
  const std::string unknown = files_.write("unknown.yaml", gains + "taskGains: 3\n");
  const std::string own = "slerpDurationErrorGain: 2.5";
  const std::string text = files_.write("text.yaml", gains.replace(gains.find(own), own.size(), own + "x"));
  for (const std::string& file : {unknown, text, files_ / "none.yaml"}) {
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"export", file}, {"compare", "--gains", "published", file}}) {
      const InputError error = refused_command(command);
      EXPECT_THAT(error, refused_at({.file = file}));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("--robot"))) << "another arm would not help";
    }
  }
  for (const std::string format : {"ros3", "csv"})
    EXPECT_THAT(refused_command({"export", "published", "--format", format}).what(),
                testing::StartsWith("--format: " + format + " "));
  EXPECT_THAT(refused_command({"export", "published", "--format", "ros1", "--node", "a b"}).what(),
              testing::StartsWith("node 'a b': "));
  const std::string run = files_ / "simulated";
  ASSERT_EQ(run_program({"simulate", files_ / "short.yaml", "--gains", files_ / "gains.yaml", "--out", run})
                .exit_code,
            0);
  EXPECT_THAT(refused_command({"export", run}).what(), testing::ContainsRegex("no study.yaml.*--robot$"));
  EXPECT_EQ(run_program({"export", run, "--robot", "ur10"}).exit_code, 0);
  EXPECT_THAT(refused_command({"export", "published", "--out", files_ / "none/gains.yaml"}),
              refused_at({.file = files_ / "none/gains.yaml"}));
}

TEST_F(ExportCommand, GivesAFileOfAnotherControllerBackWithOtherNumbers) {
  std::string text =
      "arm_controller:   # ours\n  ros__parameters:\n    command_interfaces: [effort]\n    gains:\n";
  for (const std::string& joint : joints_) text += "      " + joint + ": {p: 1000.0, i: 0.0, d: 100}\n";
  const std::string file = files_.write("controllers.yaml", text);
  Gains gains = load_gains(file, joints_);
  own(gains, "jtc_p")[1] = 1234.5;
  own(gains, "jtc_d")[0] = 0.1;
  const std::string tuned = files_.write("tuned.yaml", gains_yaml(gains, {}));
  const Finished done = run_program({"export", tuned, "--into", file, "--out", files_ / "new.yaml"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  std::string expected = text;
  expected.replace(expected.find("d: 100}"), 6, "d: 0.1");
  expected.replace(expected.find("p: 1000.0", expected.find(joints_[1])), 9, "p: 1234.5");
  EXPECT_EQ(test::read_text(files_ / "new.yaml"), expected);
  EXPECT_EQ(run_program({"export", tuned, "--into", file}).exit_code, 2)
      << "a terminal is no place for its bytes";

  const Finished other = run_program({"export", "published", "--into", file, "--out", files_ / "no.yaml"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, AllOf(HasSubstr("'adaptive'"), HasSubstr("is a joint_trajectory_controller")));
  EXPECT_EQ(
      run_program({"export", tuned, "--into", files_ / "none.yaml", "--out", files_ / "no.yaml"}).exit_code,
      2);
  EXPECT_EQ(run_program({"export", tuned, "--into", file, "--node", "other", "--out", files_ / "no.yaml"})
                .exit_code,
            2);
}

TEST_F(ExportCommand, ComparesGainsWithoutASimulation) {
  const Finished done = run_program({"compare", "published", "extended_tuned", "--gains"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, AllOf(ContainsRegex("gain +unit +published +extended_tuned +ratio\n"),
                              ContainsRegex("task_space_gains_p/x +1/s +80 "), HasSubstr("are the same")));
  const Finished same = run_program({"compare", "published", "published", "--gains"});
  EXPECT_THAT(same.out, testing::StartsWith("all "));
  EXPECT_EQ(run_program({"compare", "published", "--gains", "--out", files_ / "x"}).exit_code, 2);
  EXPECT_EQ(run_program({"compare", "published", "extended", "--gains", "--stepper", "rk4"}).exit_code, 2);
  EXPECT_THAT(run_program({"compare", "published", "--gains"}).err, HasSubstr("two or more"));
  // What no file is called after may have any name.
  std::filesystem::copy_file(files_ / "gains.yaml", files_ / "=x.yaml");
  const Finished formula = run_program({"compare", files_ / "=x.yaml", files_ / "gains.yaml", "--gains"});
  EXPECT_EQ(formula.exit_code, 0) << formula.err;
  EXPECT_THAT(formula.out, testing::StartsWith("all "));
  const Finished arms = run_program({"compare", "panda", "panda_tuned", "--gains"});
  EXPECT_EQ(arms.exit_code, 2);
  EXPECT_THAT(arms.err, HasSubstr("--robot"));
  EXPECT_THAT(run_program({"compare", "panda", "panda_tuned", "--gains", "--robot", "panda"}).out,
              HasSubstr("task_space_gains_d/panda_joint7"));
}

}  // namespace export_test
}  // namespace armtune::internal
