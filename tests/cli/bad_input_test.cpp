// Bad input: exit code 2, nothing on stdout, and exactly one line on stderr that says where and what.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace bad_input_test {

using test::Finished;
using test::refused_at;
using test::refused_command;
using test::ShortStudy;
using testing::EndsWith;
using testing::HasSubstr;

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
    const InputError error = refused_command(arguments);
    EXPECT_THAT(error, refused_at({.file = arguments.back()}));
    faults.insert(std::string(error.what()).substr(arguments.back().size()));
  }
  EXPECT_EQ(faults.size(), 1U) << "the same fault, whatever the file was to be: "
                               << testing::PrintToString(faults);
  const std::string empty = files_.write("empty.yaml", "");
  EXPECT_THAT(refused_command({"tune", empty}), refused_at({.file = empty, .limit = "a YAML document"}));
}

TEST_F(BadInput, AnObjectiveTermThatTheScenarioHasNothingFor) {
  for (const std::string floor : {"", ", floor: 0.1"}) {
    const std::string path = ShortStudyText(
        test::kShortParameters, "objective:\n  - {metric: obstacle/min_clearance" + floor + "}\n", "", "");
    for (const char* command : {"tune", "pareto"}) {
      EXPECT_THAT(
          refused_command({command, path}),
          refused_at(
              {.file = path, .line = 7, .key = "objective/0/metric", .value = "obstacle/min_clearance"}));
    }
  }
}

TEST_F(BadInput, Xacro) {
  const std::string path = files_.write("arm.urdf",
                                        "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
                                        "  <xacro:include filename='macros.xacro'/>\n</robot>\n");
  const InputError error = refused_command({"robot", path});
  EXPECT_THAT(error, refused_at({.file = path, .line = 2, .value = "<xacro:include>"}));
  EXPECT_THAT(error.what(), HasSubstr("xacro " + path + " > "));
}

TEST_F(BadInput, JointWithoutLimits) {
  const std::string path =
      files_.write("arm.urdf", test::robot(test::one_joint(test::kInertial, "<axis xyz='0 0 1'/>")));
  const InputError error = refused_command({"robot", path});
  EXPECT_THAT(error, refused_at({.file = path}));
  EXPECT_THAT(error.what(), HasSubstr(": position limits of j; velocity limit of j; effort limit of j."));
  const std::string endless = files_.write(
      "endless.urdf", test::robot(test::link("a", "") + test::link("b") +
                                  test::joint("turning", "continuous", "a", "b", "<axis xyz='0 0 1'/>")));
  EXPECT_THAT(refused_command({"robot", endless}).what(),
              HasSubstr(": velocity limit of turning; effort limit of turning."));
}

TEST_F(BadInput, ARobotThatLacksDataGetsAYamlThatGivesIt) {
  const std::string urdf =
      test::robot(test::link("a", "") + test::link("b", "") +
                  test::joint("j", "revolute", "a", "b",
                              "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='0' effort='0'/>"));
  const std::string path = files_.write("arm.urdf", urdf);
  EXPECT_THAT(refused_command({"robot", path}).what(),
              HasSubstr(": velocity limit of j; effort limit of j; inertia of b. The option --sidecar"));
  const std::string sidecar = files_ / "arm.yaml";
  EXPECT_EQ(test::run_program({"robot", path, "--sidecar", sidecar}).exit_code, 0);
  EXPECT_THAT(refused_command({"robot", path, "--sidecar", sidecar}), refused_at({.file = sidecar}));
  EXPECT_THAT(refused_command({"robot", sidecar}),
              refused_at({.file = sidecar, .line = 4, .key = "limits/j/velocity", .limit = "a number"}));
  std::string yaml = test::read_text(sidecar);
  for (const auto& [key, value] : {std::pair{"velocity:", " 2"}, std::pair{"effort:", " 3"},
                                   std::pair{"mass:", " 4"}, std::pair{"moments:", " [1, 0, 0, 1, 0, 1]"}}) {
    const auto at = yaml.find(key);
    ASSERT_NE(at, std::string::npos) << key;
    yaml.insert(at + std::string(key).size(), value);
  }
  const Finished whole = test::run_program({"robot", files_.write("arm.yaml", yaml)});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_THAT(whole.out, testing::ContainsRegex("1 joints.*moving mass 4 kg"));
}

TEST_F(BadInput, ARobotWithImpossibleInertiaGetsAYamlToo) {
  const std::string path = files_.write(
      "arm.urdf",
      test::robot(test::one_joint("<inertial><mass value='-2'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
                                  "ixz='0' iyz='0'/></inertial>")));
  EXPECT_THAT(refused_command({"robot", path}).what(),
              HasSubstr(" inertia of b (mass -2 kg). The option --sidecar"));
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
  EXPECT_THAT(refused_command({"simulate", scenario}),
              refused_at({.file = scenario, .line = 2, .key = "durations", .suggestion = "duration"}));
  const std::string gains = gains_with("slerpDurationErrorGain:", "slerpDurationErrorGian:");
  EXPECT_THAT(refused_command({"simulate", files_ / "short.yaml", "--gains", gains}),
              refused_at({.file = gains, .line = 1, .limit = "the key 'slerpDurationErrorGain'"}));
  const std::string study =
      ShortStudyText(test::kShortParameters, test::kShortObjective, "constrains: []\n", "");
  EXPECT_THAT(refused_command({"tune", study}),
              refused_at({.file = study, .line = 9, .key = "constrains", .suggestion = "constraints"}));
}

TEST_F(BadInput, BoundCrossed) {
  const std::string study =
      study_with("parameters:\n  - {name: slerpDurationErrorGain, lower: 4, upper: 1}\n");
  EXPECT_THAT(refused_command({"tune", study}), refused_at({.file = study,
                                                            .key = "slerpDurationErrorGain",
                                                            .value = "4",
                                                            .limit = "below the upper bound 1"}));
}

TEST_F(BadInput, WrongCountOfGains) {
  const std::string gains = gains_with("task_space_gains_d: [280.0, ", "task_space_gains_d: [");
  EXPECT_THAT(refused_command({"simulate", files_ / "short.yaml", "--gains", gains}),
              refused_at({.file = gains,
                          .key = "simple_effort_ctrl/task_space_gains_d",
                          .value = "5",
                          .limit = "6 numbers"}));
}

TEST_F(BadInput, UnknownNames) {
  EXPECT_THAT(refused_command({"simulate", "moving_traget"}),
              refused_at({.value = "moving_traget", .suggestion = "moving_target"}));
  EXPECT_THAT(refused_command({"simulate", "moving_target", "--gains", "publishd"}),
              refused_at({.value = "publishd", .suggestion = "published"}));
  EXPECT_THAT(
      refused_command({"simulate", files_ / "short.yaml", "--stepper", "rk5"}),
      refused_at(
          {.key = "stepper", .value = "rk5", .limit = "midpoint, semi_implicit_euler, rk4 or reference"}));
  EXPECT_THAT(refused_command({"simulate", files_ / "short.yaml", "--engine", "bullet"}),
              refused_at({.key = "engine", .value = "bullet", .limit = "simbody or native"}));
  EXPECT_THAT(
      refused_command({"simulate", files_ / "short.yaml", "--engine", "native", "--stepper", "reference"}),
      refused_at({.key = "stepper", .value = "reference", .limit = "engine simbody, or the stepper rk4"}));
  EXPECT_THAT(refused_command({"tune", "ur10_gase"}),
              refused_at({.value = "ur10_gase", .suggestion = "ur10_gaze"}));
  EXPECT_THAT(refused_command({"robot", "ur11"}), refused_at({.value = "ur11", .suggestion = "ur10"}));
  EXPECT_THAT(refused_command({"compare", "published", "--scenarios", "fixed_targe"}),
              refused_at({.value = "fixed_targe", .suggestion = "fixed_target"}));
}

TEST_F(BadInput, WhatWouldGiveNoNumbersOrTwoMeanings) {
  const std::string base = "base: moving_target\nduration: 1\n";
  const std::string two =
      "targets:\n  - {name: red, hold: [0, 0, 0]}\n  - {name: red, hold: [-0.6, 0, 0]}\nschedule: []\n";
  EXPECT_THAT(refused_command({"simulate", files_.write("two.yaml", base + two)}),
              refused_at({.file = files_ / "two.yaml", .line = 5, .key = "targets/1/name", .value = "red"}));
  const std::string fast =
      "targets: [{name: a, polyline: {corners: [[0, 0, 0], [1, 0, 0]], speed: 1e300, blend: 0.1}}]\n";
  EXPECT_THAT(refused_command({"simulate", files_.write("fast.yaml", base + fast)}),
              refused_at({.file = files_ / "fast.yaml", .line = 3, .key = "targets/0/polyline"}));
  EXPECT_THAT(refused_command({"simulate", files_.write("latin.yaml", base + "description: caf\xe9\n")}),
              refused_at({.file = files_ / "latin.yaml", .line = 3}));
  EXPECT_THAT(refused_command({"tune", study_with("parameters:\n  - {name: slerpDurationErrorGain, lower: "
                                                  "2.3e-308}\n")}),
              refused_at({.key = "slerpDurationErrorGain", .value = "2.3e-308"}));
  const std::string heavy =
      "objective:\n  - {metric: error/orientation/rms, weight: 1e308}\n  - {metric: error/position/max, "
      "weight: 1e308}\n";
  EXPECT_THAT(refused_command({"tune", ShortStudyText(test::kShortParameters, heavy, test::kShortConstraints,
                                                      test::kShortSearch)}),
              refused_at({.line = 7, .key = "objective/0/weight", .value = "1e308"}));
}

TEST_F(BadInput, LeavesNoFolderBehind) {
  refused_command({"tune", study_with("parameters:\n  - {name: no_such_gain}\n"), "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
  refused_command({"simulate", "moving_traget", "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
  refused_command(
      {"identify", files_.write("log.csv", "time,q\n0,1\n"), "--robot", "ur10", "--out", files_ / "run"});
  EXPECT_FALSE(std::filesystem::exists(files_ / "run"));
}

TEST_F(BadInput, Usage) {
  EXPECT_THAT(refused_command({"simulate", "moving_target", "--frob"}).what(), EndsWith("--frob"));
  EXPECT_THAT(refused_command({"tune", "--workers", "abc"}).what(), HasSubstr("abc"));
  EXPECT_THAT(refused_command({"identify", files_ / "no\nlog.csv", "--robot", "ur10"}).what(),
              HasSubstr("no\\nlog.csv"));
  const std::string arm = files_ / "no\narm.urdf";
  EXPECT_THAT(refused_command({"robot", arm}), refused_at({.file = arm}));
}

TEST_F(BadInput, StepperOrEngineOfAStudy) {
  for (const std::string key : {"stepper", "engine"}) {
    const std::string study = ShortStudyText(test::kShortParameters, test::kShortObjective,
                                             test::kShortConstraints, "search:\n  " + key + ": rk9\n");
    EXPECT_THAT(refused_command({"tune", study}),
                refused_at({.file = study, .line = 13, .key = "search/" + key, .value = "rk9"}));
  }
}

TEST_F(BadInput, StartGainsThatDoNotCompleteAreNoReference) {
  files_.write("short.yaml", "base: moving_target\nduration: 3\n");
  const std::string study = study_with(test::kShortParameters);
  EXPECT_THAT(refused_command({"tune", study, "--out", files_ / "run", "--workers", "1"}),
              refused_at({.file = study, .key = "gains", .value = "short"}));
}

TEST_F(BadInput, TwoScenariosOfOneNameAreRefused) {
  EXPECT_THAT(refused_command({"simulate", "moving_target", "moving_target"}),
              refused_at({.value = "moving_target", .limit = "another name"}));
}

}  // namespace bad_input_test
}  // namespace armtune::internal
