// Study files with a fault are refused where the fault stands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_refusals_test {

using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;

/// Message with which a study of these parts is refused.
std::string refusal(const std::string& parameters, const std::string& objective = test::kShortObjective,
                    const std::string& constraints = test::kShortConstraints,
                    const std::string& search = test::kShortSearch) {
  const ShortStudy files(parameters, objective, constraints, search);
  std::string message = test::refusal([&] { load_study(files.path()); });
  EXPECT_THAT(message, testing::StartsWith(files.path()));
  return message;
}

TEST(StudyFile, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gain_p/rx}\n"),
              AllOf(HasSubstr("is not a gain"), HasSubstr("did you mean 'task_space_gains_p/rx'")));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: error/orientaton/rms}\n"),
              AllOf(HasSubstr("is not a metric"), HasSubstr("did you mean 'error/orientation/rms'")));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocty/max_ratio, at_most: 1}\n"),
              HasSubstr("did you mean 'joint_velocity/max_ratio'"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, scenarios: [shirt]}\n"),
              HasSubstr("'shirt' is not one of the study's scenarios"));
}

TEST(StudyFile, AnAlgorithmOrStepperThatIsNotOfferedIsRefused) {
  const auto search = [](const std::string& text) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "", "search: {" + text + "}\n");
    return test::refusal([&] { load_study(files.path()); });
  };
  EXPECT_THAT(search("algorithm: COBYLLA"), AllOf(HasSubstr("COBYLLA"), HasSubstr("did you mean 'COBYLA'")));
  EXPECT_THAT(search("stepper: euler"), AllOf(HasSubstr("euler"), HasSubstr("midpoint")));
  EXPECT_THAT(search("engine: mujoco"), AllOf(HasSubstr("mujoco"), HasSubstr("native")));
  EXPECT_THAT(search("verify_share: 0.2"), HasSubstr("engine: native"));
  EXPECT_THAT(search("engine: native, verify_share: 1.5"), HasSubstr("1.5"));
  EXPECT_THAT(search("engine: native, stepper: reference"), HasSubstr("'reference'"));
  EXPECT_THAT(search("max_evaluations: 0"), HasSubstr("max_evaluations"));
  EXPECT_THAT(search("seed: -1"), HasSubstr("negative"));
  EXPECT_THAT(search("budget: 10"), HasSubstr("unknown key 'budget'"));
}

TEST(StudyFile, SearchKeysThatDoNotFitAreRefusedWithTheirLine) {
  const auto search = [](const std::string& text) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "", "search:\n  " + text + "\n");
    std::string message = test::refusal([&] { load_study(files.path()); });
    // Line 10 is `search:`, after description, gains, scenarios, three lines of parameters and of objective.
    EXPECT_THAT(message, testing::StartsWith(files.path() + ":11: key 'search/"));
    return message;
  };
  EXPECT_THAT(search("global: CRS3"), AllOf(HasSubstr("global"), HasSubstr("did you mean 'CRS2'")));
  EXPECT_THAT(search("algorithm: SLQSP"), HasSubstr("did you mean 'SLSQP'"));
  EXPECT_THAT(search("global_share: 1.5"), AllOf(HasSubstr("1.5"), HasSubstr("1")));
  EXPECT_THAT(search("global_share: -0.5"), HasSubstr("-0.5"));
  EXPECT_THAT(search("global_share: 0.5\n  algorithm: COBYLA"), HasSubstr("name one with 'global'"));
  EXPECT_THAT(search("starts: 0"), AllOf(HasSubstr("0 searches"), HasSubstr("1 .. 256")));
  EXPECT_THAT(search("starts: 1000"), HasSubstr("1 .. 256"));
  EXPECT_THAT(search("differences: backward"), HasSubstr("forward, central"));
  EXPECT_THAT(search("difference_step: 0"), HasSubstr("difference_step"));
}

// The default bounds are multiples of the start, so that there is nothing between them.
TEST(StudyFile, AParameterThatStartsAtZeroNeedsBoundsOfItsOwn) {
  const std::string parameter = "parameters:\n  - {name: adaptation_gain, start: 0";
  EXPECT_THAT(refusal(parameter + "}\n"), AllOf(HasSubstr("parameter adaptation_gain"),
                                                HasSubstr("start value is 0"), HasSubstr("'upper'")));
  const ShortStudy bounded(parameter + ", lower: 0, upper: 0.1, scale: linear}\n");
  EXPECT_EQ(load_study(bounded.path()).space.free[0].start, 0.0);
}

TEST(StudyFile, UnknownControllersAndGainsOfOthersAreRefused) {
  EXPECT_THAT(refusal("controller: impedance\n" + test::kShortParameters),
              AllOf(HasSubstr("task_space_gains_p/rx"), HasSubstr("is not a gain")));
  EXPECT_THAT(refusal("controller: pid\n"),
              AllOf(HasSubstr(":4"), HasSubstr("'pid'"), HasSubstr("joint_pd")));
}

TEST(StudyFile, AnUnknownScenarioIsRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write(
      "study.yaml", "gains: published\nscenarios: [moving_tarket]\nobjective:\n  - {metric: gaze/rms}\n");
  EXPECT_THAT(test::refusal([&] { load_study(path); }),
              AllOf(HasSubstr("moving_tarket"), HasSubstr("did you mean 'moving_target'")));
}

TEST(StudyFile, ParametersThatDoNotFitAreRefused) {
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, lower: 60, upper: 10}\n"),
              AllOf(HasSubstr("task_space_gains_p/rx"), HasSubstr("not below")));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, lower: 30, upper: 60}\n"),
              HasSubstr("start 25 lies outside its bounds 30 .. 60"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, fixed: 1, link: adaptation_gain}\n"),
              HasSubstr("at most one of"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, link: task_space_gains_p/ry}\n"),
              HasSubstr("'task_space_gains_p/ry' is not a tuned parameter"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, fixed: 30}\n"),
              HasSubstr("no parameter"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, scale: cubic}\n"), HasSubstr("cubic"));
}

TEST(StudyFile, ConstraintsAndTermsThatSayNothingAreRefused) {
  EXPECT_THAT(refusal(test::kShortParameters, "objective: []\n"), HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, weight: 0}\n"),
              HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, weight: -1}\n"),
              HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocity/max_ratio}\n"),
              HasSubstr("at_most"));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 1, at_least: 0}\n"),
              HasSubstr("at_most"));
}

TEST(StudyFile, EndsThatMakeNoSenseAreRefused) {
  const auto constraint = [](const std::string& text) {
    return refusal(test::kShortParameters, test::kShortObjective, "constraints:\n  - {" + text + "}\n");
  };
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: 0.9"),
              AllOf(HasSubstr("hopeless"), HasSubstr("at_most 0.9"), HasSubstr("above")));
  EXPECT_THAT(constraint("metric: joint_position/min_margin, at_least: 0.2, hopeless: 0.3"),
              AllOf(HasSubstr("at_least 0.2"), HasSubstr("below")));
  EXPECT_THAT(constraint("metric: error/position/rms, at_most: 1, hopeless: 2"),
              AllOf(HasSubstr("can still meet it at the end"), HasSubstr("error/position/max")));
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_least: 0.2, hopeless: 0.1"),
              AllOf(HasSubstr("can still meet it at the end"), HasSubstr("joint_position/min_margin")));
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: soon"),
              HasSubstr("soon"));
}

TEST(StudyFile, RefusesToMoveParametersOnceALinkStands) {
  const std::string linked =
      "parameters:\n"
      "  - {name: task_space_gains_p/rx}\n"
      "  - {name: task_space_gains_p/rz}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx}\n";
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/rx, lower: 1}\n"),
              HasSubstr("task_space_gains_p/rx"));
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/ry, fixed: 3}\n"),
              HasSubstr("task_space_gains_p/ry"));
}

TEST(StudyFile, RefusesGainsThatNoControllerTakes) {
  EXPECT_THAT(refusal("parameters:\n  - {name: slerpDurationErrorGain}\n"
                      "  - {name: task_space_gains_p/x, fixed: -80}\n"),
              AllOf(HasSubstr("task_space_gains_p/x"), HasSubstr("-80")));
  EXPECT_THAT(refusal("parameters:\n  - {name: release_radius, start: 0.4, lower: 0.1, upper: 0.5}\n"),
              HasSubstr("release_radius"));
}

TEST(StudyFile, WeightsFloorsAndLimitsOutsideTheirRangeAreRefusedWhereTheyStand) {
  const auto objective = [](const std::string& weight, const std::string& floor) {
    return "objective:\n  - {metric: error/orientation/rms, weight: 1}\n  - {metric: error/position/max, "
           "weight: " +
           weight + ", floor: " + floor + "}\n";
  };
  for (const std::string number : {"1e308", "1e13", "1e-13", "2.3e-308"}) {
    EXPECT_THAT(refusal(test::kShortParameters, objective(number, "0")), HasSubstr("objective/1/weight"));
    EXPECT_THAT(refusal(test::kShortParameters, objective("1", number)), HasSubstr("objective/1/floor"));
    EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                        "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: " + number + "}\n"),
                HasSubstr("constraints/0/at_most"));
  }
  for (const std::string number : {"0", "1e12", "1e-12"}) {
    EXPECT_NO_THROW(load_study(ShortStudy(test::kShortParameters, objective(number, number)).path()))
        << number;
  }
}

TEST(StudyFile, ANameThatNoFileCouldBeCalledAfterIsRefused) {
  const ShortStudy files;
  for (const std::string& name : {std::string(201, 's'), std::string("a\x1b[31m"), std::string("caf\xE9")}) {
    const std::string path = files / (name + ".yaml");
    std::filesystem::copy_file(files.path(), path);
    EXPECT_THAT(test::refusal([&] { load_study(path); }), HasSubstr("rename"));
  }
}

}  // namespace study_refusals_test
}  // namespace armtune::internal
