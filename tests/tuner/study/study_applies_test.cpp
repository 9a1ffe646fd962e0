// Terms and constraints count in the scenarios that their metric applies to.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_applies_test {

using test::refused_at;
using testing::HasSubstr;

/// short, and short with an obstacle and a switch of targets added.
class StudyOfTwoKindsOfScenario : public testing::Test {
 protected:
  StudyOfTwoKindsOfScenario() {
    files_.write("short.yaml", "base: moving_target\nduration: 8\n");
    files_.write("with_obstacle.yaml", "base: obstacle_pass\nduration: 8\n");
  }
  std::string write(const std::string& scenarios, const std::string& rest) const {
    return files_.write("study.yaml", "gains: published\nscenarios: [" + scenarios +
                                          "]\nparameters: [{name: task_space_gains_p/rx}]\n" + rest);
  }
  Study study(const std::string& rest) const {
    return load_study(write("short.yaml, with_obstacle.yaml", rest));
  }
  /// Returns the error with which a study is refused. It is in line 5, the second one of `rest`.
  InputError refusal(const std::string& scenarios, const std::string& rest) const {
    const std::string path = write(scenarios, rest);
    InputError error = test::input_error([&] { load_study(path); });
    EXPECT_THAT(error, refused_at({.file = path, .line = 5}));
    return error;
  }

  const test::TemporaryFolder files_;
};

TEST_F(StudyOfTwoKindsOfScenario, ATermWithoutScenariosCountsWhereItsMetricApplies) {
  const Study both = study("objective:\n  - {metric: obstacle/min_clearance}\n  - {metric: gaze/rms}\n");
  EXPECT_THAT(both.terms[0].scenarios, testing::ElementsAre(1U));
  EXPECT_THAT(both.terms[1].scenarios, testing::ElementsAre(0U, 1U));
  // The resolved form says so.
  EXPECT_THAT(study_yaml(both, "published"),
              HasSubstr("{metric: obstacle/min_clearance, weight: 1, floor: 0, scenarios: [with_obstacle]}"));
}

TEST_F(StudyOfTwoKindsOfScenario, ATermThatAppliesNowhereIsRefusedWithTheScenario) {
  for (const std::string floor : {"", ", floor: 0.1"}) {
    const InputError error =
        refusal("short.yaml", "objective:\n  - {metric: obstacle/min_clearance" + floor + "}\n");
    EXPECT_THAT(error, refused_at({.key = "objective/0/metric", .value = "obstacle/min_clearance"}));
    EXPECT_THAT(error.what(), HasSubstr("does not apply to short;"));
  }
}

TEST_F(StudyOfTwoKindsOfScenario, AListedScenarioThatATermDoesNotApplyToIsRefused) {
  EXPECT_THAT(
      refusal("short.yaml, with_obstacle.yaml",
              "objective:\n  - {metric: obstacle/min_clearance, scenarios: [with_obstacle, short]}\n"),
      refused_at({.key = "objective/0/scenarios/1", .value = "short"}));
}

TEST_F(StudyOfTwoKindsOfScenario, AConstraintMustApplySomewhere) {
  const std::string objective = "objective: [{metric: gaze/rms}]\nconstraints: ";
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1}]\n"));
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1, "
                                    "scenarios: [short, with_obstacle]}]\n"));
  const std::string both = "short.yaml, with_obstacle.yaml";
  const InputError nowhere = refusal(both, objective + "[{metric: response/bandwidth, at_least: 5}]\n");
  EXPECT_THAT(nowhere, refused_at({.key = "constraints/0/metric", .value = "response/bandwidth"}));
  EXPECT_THAT(nowhere.what(), HasSubstr("short, with_obstacle"));
  EXPECT_THAT(
      refusal(both, objective + "[{metric: obstacle/min_clearance, at_least: 0.1, scenarios: [short]}]\n"),
      refused_at({.key = "constraints/0/scenarios"}));
}

TEST_F(StudyOfTwoKindsOfScenario, AMetricWithoutADirectionIsNoTermButMayBeBounded) {
  EXPECT_THAT(refusal("short.yaml", "objective:\n  - {metric: joint_velocity/max_ratio_time}\n"),
              refused_at({.key = "objective/0/metric", .value = "joint_velocity/max_ratio_time"}));
  EXPECT_NO_THROW(
      study("objective: [{metric: gaze/rms}, {metric: samples}]\n"
            "constraints: [{metric: joint_velocity/max_ratio_time, at_least: 1}]\n"));
}

}  // namespace study_applies_test
}  // namespace armtune::internal
