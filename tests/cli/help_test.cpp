#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/support/program.hpp"

namespace armtune {
namespace {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

TEST(Help, OfTheProgramShowsHowToBeginAndWhatExitCodesMean) {
  const Finished help = run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_THAT(help.out,
              AllOf(HasSubstr("armtune simulate moving_target"), HasSubstr("robot"), HasSubstr("simulate"),
                    HasSubstr("tune"), HasSubstr("compare"), HasSubstr("130 interrupted")));
}

TEST(Help, OfEveryCommandShowsDefaultsAndWhatIsBundled) {
  const auto help = [](const char* command) {
    const Finished finished = run_program({command, "--help"});
    EXPECT_EQ(finished.exit_code, 0) << command;
    EXPECT_EQ(finished.err, "") << command;
    return finished.out;
  };
  EXPECT_THAT(help("robot"), HasSubstr("ur10"));
  EXPECT_THAT(help("simulate"), AllOf(HasSubstr("moving_target"), HasSubstr("realistic_obstacle_pass"),
                                      HasSubstr("published"), HasSubstr("midpoint"), HasSubstr("--out")));
  EXPECT_THAT(help("tune"),
              AllOf(HasSubstr("ur10_gaze"), HasSubstr("COBYLA"), HasSubstr("ISRES"),
                    HasSubstr("slerpDurationErrorGain"), HasSubstr("reacquisition/time"),
                    HasSubstr("--max-evaluations"), HasSubstr("--seed"), HasSubstr("--warm-start"),
                    HasSubstr("hopeless"), HasSubstr("global_share"), HasSubstr("takes constraints"),
                    HasSubstr("uses differences"), HasSubstr("draws random numbers")));
  EXPECT_THAT(help("robustness"), AllOf(HasSubstr("--payload"), HasSubstr("--limit"), HasSubstr("1000")));
  for (const char* command : {"tune", "pareto", "robustness", "sensitivity"}) {
    EXPECT_THAT(help(command), AllOf(HasSubstr("--rollout-deadline"), HasSubstr("every rank is one worker")))
        << command;
  }
  EXPECT_THAT(help("margins"), AllOf(HasSubstr("control_rate"), HasSubstr("1 % of the control periods"),
                                     HasSubstr("--limit"), HasSubstr("armtune margins extended_tuned")));
  EXPECT_THAT(help("plan"), AllOf(HasSubstr("ur10_switch"), HasSubstr("--knots"), HasSubstr("fastest"),
                                  HasSubstr("slowly first")));
  EXPECT_THAT(help("yardstick"), AllOf(HasSubstr("RUN"), HasSubstr("a local optimum")));
  EXPECT_THAT(help("compare"), AllOf(HasSubstr("--scenarios"), HasSubstr("midpoint")));
  EXPECT_THAT(help("report"), AllOf(HasSubstr("DIR"), HasSubstr("--out"), HasSubstr("report.html")));
  for (const char* command : {"simulate", "compare", "robustness"}) {
    EXPECT_THAT(help(command), HasSubstr("report.html")) << command;
  }
}

TEST(Help, VersionNamesTheLibraries) {
  const Finished version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, AllOf(HasSubstr("armtune 0."), HasSubstr("simbody 3."), HasSubstr("nlopt "),
                                 HasSubstr("eigen 3."), HasSubstr("yaml_cpp "), HasSubstr("open_mpi ")));
}

TEST(Help, WrongUsageEndsWithTwo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"simulate"},
                                                    {"tun"},
                                                    {"simulate", "moving_target", "--no-such-option"},
                                                    {"tune", "--max-evaluations", "0"},
                                                    {"simulate", "moving_target", "--workers", "many"}}) {
    const Finished finished = run_program(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err, "");
  }
}

TEST(Robot, ShowsJointsLimitsMassesAndReach) {
  const Finished shown = run_program({"robot", "ur10"});
  EXPECT_EQ(shown.exit_code, 0);
  for (const char* joint : {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint",
                            "wrist_2_joint", "wrist_3_joint"}) {
    EXPECT_THAT(shown.out, HasSubstr(joint));
  }
  EXPECT_THAT(shown.out, AllOf(HasSubstr("6 joints"), HasSubstr("kg"), HasSubstr("reach"), HasSubstr("330"),
                               HasSubstr("2.16"), HasSubstr("12.93")));
}

TEST(Help, SaysWhatIsWrongWhereTheBundledDataIsMissing) {
  ASSERT_EQ(::setenv("ARMTUNE_DATA", "/nonexistent", 1), 0);
  const Finished help = run_program({"tune", "--help"});
  ::unsetenv("ARMTUNE_DATA");
  EXPECT_EQ(help.exit_code, 2);
  EXPECT_THAT(help.err, testing::HasSubstr("/nonexistent"));
}

TEST(Help, IsWhatTheBareProgramShows) {
  const Finished bare = run_program({});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_THAT(bare.err, testing::HasSubstr("armtune tune"));
}

}  // namespace
}  // namespace armtune
