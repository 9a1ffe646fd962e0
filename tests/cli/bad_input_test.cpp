// Bad input: exit code 2, nothing on stdout, and exactly one line on stderr that says where and what.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/cli/support/program.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace bad_input_test {

using test::Finished;
using test::ShortStudy;
using testing::HasSubstr;

/// Checks that the command is refused in one line, and gives that line.
std::string refused(const std::vector<std::string>& arguments) {
  const Finished finished = test::run_program(arguments);
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  EXPECT_THAT(finished.err, testing::StartsWith("armtune: "));
  return finished.err;
}

/// Scenario, gains and study in a folder, and variants of each.
class BadInput : public testing::Test {
 protected:
  std::string study_with(const std::string& parameters) const {
    return ShortStudyText(parameters, test::kShortObjective, test::kShortConstraints, test::kShortSearch);
  }
  std::string ShortStudyText(const std::string& parameters, const std::string& objective,
                             const std::string& constraints, const std::string& search) const {
    return files_.write("bad_study.yaml", "gains: gains.yaml\nscenarios: [short.yaml]\n" + parameters +
                                              objective + constraints + search);
  }
  std::string gains_with(const std::string& from, const std::string& to) const {
    std::string text = test::read_text(files_ / "gains.yaml");
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return files_.write("bad_gains.yaml", text.replace(at, from.size(), to));
  }

  const ShortStudy files_;
};

TEST_F(BadInput, MissingFile) {
  const std::string path = files_ / "nowhere.yaml";
  std::set<std::string> faults;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"simulate", path},
                                                    {"simulate", "moving_target", "--gains", path},
                                                    {"tune", path},
                                                    {"robot", path},
                                                    {"robot", files_ / "nowhere.urdf"},
                                                    {"compare", path}}) {
    const std::string place = "armtune: " + arguments.back() + ": ";
    const std::string error = refused(arguments);
    ASSERT_THAT(error, testing::StartsWith(place));
    faults.insert(error.substr(place.size()));
  }
  EXPECT_EQ(faults.size(), 1U) << "the same fault, whatever the file was to be: "
                               << testing::PrintToString(faults);
  const std::string empty = files_.write("empty.yaml", "");
  EXPECT_THAT(refused({"tune", empty}), testing::Not(HasSubstr(*faults.begin())));
}

TEST_F(BadInput, AnObjectiveTermThatTheScenarioHasNothingFor) {
  for (const std::string floor : {"", ", floor: 0.1"}) {
    const std::string path = ShortStudyText(
        test::kShortParameters, "objective:\n  - {metric: obstacle/min_clearance" + floor + "}\n", "", "");
    for (const char* command : {"tune", "pareto"}) {
      EXPECT_THAT(refused({command, path}), testing::AllOf(HasSubstr(path + ":7:"), HasSubstr("short"),
                                                           HasSubstr("obstacle/min_clearance")));
    }
  }
}

TEST_F(BadInput, Xacro) {
  const std::string path = files_.write("arm.urdf",
                                        "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
                                        "  <xacro:include filename='macros.xacro'/>\n</robot>\n");
  EXPECT_THAT(refused({"robot", path}),
              testing::AllOf(testing::StartsWith("armtune: " + path + ":2: "), HasSubstr("<xacro:include>"),
                             HasSubstr("xacro " + path + " > ")));
}

TEST_F(BadInput, JointWithoutLimits) {
  const std::string path =
      files_.write("arm.urdf", test::robot(test::one_joint(test::kInertial, "<axis xyz='0 0 1'/>")));
  EXPECT_THAT(
      refused({"robot", path}),
      testing::AllOf(testing::StartsWith("armtune: " + path + ": "), HasSubstr("position limits of j;"),
                     HasSubstr("velocity limit of j;"), HasSubstr("effort limit of j.")));
  const std::string endless = files_.write(
      "endless.urdf", test::robot(test::link("a", "") + test::link("b") +
                                  test::joint("turning", "continuous", "a", "b", "<axis xyz='0 0 1'/>")));
  EXPECT_THAT(refused({"robot", endless}),
              testing::AllOf(testing::StartsWith("armtune: " + endless + ": "),
                             HasSubstr("velocity limit of turning;"), HasSubstr("effort limit of turning."),
                             testing::Not(HasSubstr("position limits"))));
}

TEST_F(BadInput, ARobotThatLacksDataGetsAYamlThatGivesIt) {
  const std::string urdf =
      test::robot(test::link("a", "") + test::link("b", "") +
                  test::joint("j", "revolute", "a", "b",
                              "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='0' effort='0'/>"));
  const std::string path = files_.write("arm.urdf", urdf);
  EXPECT_THAT(refused({"robot", path}),
              testing::AllOf(HasSubstr("velocity limit of j; effort limit of j; inertia of b"),
                             HasSubstr("--sidecar")));
  const std::string sidecar = files_ / "arm.yaml";
  EXPECT_EQ(test::run_program({"robot", path, "--sidecar", sidecar}).exit_code, 0);
  EXPECT_THAT(refused({"robot", path, "--sidecar", sidecar}), HasSubstr("exists already"));
  EXPECT_THAT(refused({"robot", sidecar}), testing::AllOf(HasSubstr("arm.yaml:4"), HasSubstr("velocity")));
  std::string yaml = test::read_text(sidecar);
  for (const auto& [key, value] : {std::pair{"velocity:", " 2"}, std::pair{"effort:", " 3"},
                                   std::pair{"mass:", " 4"}, std::pair{"moments:", " [1, 0, 0, 1, 0, 1]"}}) {
    const auto at = yaml.find(key);
    ASSERT_NE(at, std::string::npos) << key;
    yaml.insert(at + std::string(key).size(), value);
  }
  const Finished whole = test::run_program({"robot", files_.write("arm.yaml", yaml)});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_THAT(whole.out, testing::AllOf(HasSubstr("1 joints"), HasSubstr("moving mass 4 kg")));
}

TEST_F(BadInput, ARobotWithImpossibleInertiaGetsAYamlToo) {
  const std::string path = files_.write(
      "arm.urdf",
      test::robot(test::one_joint("<inertial><mass value='-2'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
                                  "ixz='0' iyz='0'/></inertial>")));
  EXPECT_THAT(refused({"robot", path}), testing::AllOf(HasSubstr("b (mass -2 kg)"), HasSubstr("--sidecar")));
  const std::string sidecar = files_ / "arm.yaml";
  const Finished done = test::run_program({"robot", path, "--sidecar", sidecar});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("fill in physically possible inertia of b (mass -2 kg)"));
  std::string yaml = test::read_text(sidecar);
  const auto at = yaml.find("mass:");
  ASSERT_NE(at, std::string::npos);
  const Finished whole = test::run_program({"robot", files_.write("arm.yaml", yaml.insert(at + 5, " 2"))});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
}

TEST_F(BadInput, UnknownYamlKey) {
  const std::string scenario = files_.write("bad.yaml", "base: moving_target\ndurations: 8\n");
  EXPECT_THAT(refused({"simulate", scenario}),
              testing::AllOf(HasSubstr(scenario + ":2"), HasSubstr("did you mean 'duration'")));
  const std::string gains = gains_with("slerpDurationErrorGain:", "slerpDurationErrorGian:");
  EXPECT_THAT(refused({"simulate", files_ / "short.yaml", "--gains", gains}),
              testing::AllOf(HasSubstr(gains), HasSubstr("slerpDurationErrorGain")));
  const std::string study =
      ShortStudyText(test::kShortParameters, test::kShortObjective, "constrains: []\n", "");
  EXPECT_THAT(refused({"tune", study}),
              testing::AllOf(HasSubstr(study), HasSubstr("did you mean 'constraints'")));
}

TEST_F(BadInput, BoundCrossed) {
  const std::string study =
      study_with("parameters:\n  - {name: slerpDurationErrorGain, lower: 4, upper: 1}\n");
  EXPECT_THAT(refused({"tune", study}),
              testing::AllOf(HasSubstr(study), HasSubstr("slerpDurationErrorGain"),
                             HasSubstr("lower bound 4"), HasSubstr("upper bound 1")));
}

TEST_F(BadInput, WrongCountOfGains) {
  const std::string gains = gains_with("task_space_gains_d: [280.0, ", "task_space_gains_d: [");
  EXPECT_THAT(
      refused({"simulate", files_ / "short.yaml", "--gains", gains}),
      testing::AllOf(HasSubstr(gains), HasSubstr("task_space_gains_d"), HasSubstr("5"), HasSubstr("6")));
}

TEST_F(BadInput, UnknownNames) {
  EXPECT_THAT(refused({"simulate", "moving_traget"}), HasSubstr("did you mean 'moving_target'"));
  EXPECT_THAT(refused({"simulate", "moving_target", "--gains", "publishd"}),
              HasSubstr("did you mean 'published'"));
  EXPECT_THAT(refused({"simulate", files_ / "short.yaml", "--stepper", "rk5"}),
              testing::AllOf(HasSubstr("rk5"), HasSubstr("semi_implicit_euler")));
  EXPECT_THAT(refused({"simulate", files_ / "short.yaml", "--engine", "bullet"}),
              testing::AllOf(HasSubstr("bullet"), HasSubstr("native")));
  EXPECT_THAT(refused({"simulate", files_ / "short.yaml", "--engine", "native", "--stepper", "reference"}),
              testing::AllOf(HasSubstr("Simbody"), HasSubstr("rk4")));
  EXPECT_THAT(refused({"tune", "ur10_gase"}), HasSubstr("did you mean 'ur10_gaze'"));
  EXPECT_THAT(refused({"robot", "ur11"}), HasSubstr("did you mean 'ur10'"));
  EXPECT_THAT(refused({"compare", "published", "--scenarios", "fixed_targe"}), HasSubstr("'fixed_target'"));
}

TEST_F(BadInput, WhatWouldGiveNoNumbersOrTwoMeanings) {
  const std::string base = "base: moving_target\nduration: 1\n";
  const std::string two =
      "targets:\n  - {name: red, hold: [0, 0, 0]}\n  - {name: red, hold: [-0.6, 0, 0]}\nschedule: []\n";
  EXPECT_THAT(refused({"simulate", files_.write("two.yaml", base + two)}),
              testing::AllOf(HasSubstr("two.yaml:5"), HasSubstr("'red'")));
  const std::string fast =
      "targets: [{name: a, polyline: {corners: [[0, 0, 0], [1, 0, 0]], speed: 1e300, blend: 0.1}}]\n";
  EXPECT_THAT(refused({"simulate", files_.write("fast.yaml", base + fast)}),
              testing::AllOf(HasSubstr("fast.yaml:3"), HasSubstr("polyline")));
  EXPECT_THAT(refused({"simulate", files_.write("latin.yaml", base + "description: caf\xe9\n")}),
              testing::AllOf(HasSubstr("latin.yaml:3"), HasSubstr("UTF-8")));
  EXPECT_THAT(
      refused({"tune", study_with("parameters:\n  - {name: slerpDurationErrorGain, lower: 2.3e-308}\n")}),
      testing::AllOf(HasSubstr("slerpDurationErrorGain"), HasSubstr("2.3e-308")));
  const std::string heavy =
      "objective:\n  - {metric: error/orientation/rms, weight: 1e308}\n  - {metric: error/position/max, "
      "weight: 1e308}\n";
  EXPECT_THAT(refused({"tune", ShortStudyText(test::kShortParameters, heavy, test::kShortConstraints,
                                              test::kShortSearch)}),
              testing::AllOf(HasSubstr("bad_study.yaml:7"), HasSubstr("weight")));
}

TEST_F(BadInput, LeavesNoFolderBehind) {
  refused({"tune", study_with("parameters:\n  - {name: no_such_gain}\n"), "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
  refused({"simulate", "moving_traget", "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
  refused({"identify", files_.write("log.csv", "time,q\n0,1\n"), "--robot", "ur10", "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
}

TEST_F(BadInput, Usage) {
  EXPECT_THAT(refused({"simulate", "moving_target", "--frob"}),
              testing::AllOf(HasSubstr("--frob"), HasSubstr("--help")));
  EXPECT_THAT(refused({"tune", "--workers", "abc"}), HasSubstr("abc"));
  EXPECT_THAT(refused({"identify", files_ / "no\nlog.csv", "--robot", "ur10"}), HasSubstr("no\\nlog.csv"));
  EXPECT_THAT(refused({"robot", files_ / "no\narm.urdf"}), HasSubstr("no\\narm.urdf"));
}

TEST_F(BadInput, StepperOrEngineOfAStudy) {
  for (const std::string key : {"stepper", "engine"}) {
    const std::string study = ShortStudyText(test::kShortParameters, test::kShortObjective,
                                             test::kShortConstraints, "search:\n  " + key + ": rk9\n");
    EXPECT_THAT(
        refused({"tune", study}),
        testing::AllOf(HasSubstr(study + ":"), HasSubstr("key 'search/" + key + "'"), HasSubstr("rk9")));
  }
}

TEST_F(BadInput, StartGainsThatDoNotCompleteAreNoReference) {
  files_.write("short.yaml", "base: moving_target\nduration: 3\n");
  const std::string message =
      refused({"tune", study_with(test::kShortParameters), "--out", files_ / "run", "--workers", "1"});
  EXPECT_THAT(message, testing::AllOf(HasSubstr("bad_study.yaml"), HasSubstr("short")));
}

TEST_F(BadInput, TwoScenariosOfOneNameAreRefused) {
  EXPECT_THAT(refused({"simulate", "moving_target", "moving_target"}), HasSubstr("moving_target"));
}

}  // namespace bad_input_test
}  // namespace armtune::internal
