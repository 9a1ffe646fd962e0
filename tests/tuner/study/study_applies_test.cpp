// Terms and constraints count in the scenarios that their metric applies to.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_applies_test {

using testing::AllOf;
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
  std::string refusal(const std::string& scenarios, const std::string& rest) const {
    const std::string path = write(scenarios, rest);
    std::string message = test::refusal([&] { load_study(path); });
    EXPECT_THAT(message, testing::StartsWith(path + ":5: key '"));
    return message;
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
    EXPECT_THAT(refusal("short.yaml", "objective:\n  - {metric: obstacle/min_clearance" + floor + "}\n"),
                AllOf(HasSubstr("objective/0/metric"),
                      HasSubstr("obstacle/min_clearance does not apply to short"), HasSubstr("'scenarios'")));
  }
}

TEST_F(StudyOfTwoKindsOfScenario, AListedScenarioThatATermDoesNotApplyToIsRefused) {
  EXPECT_THAT(
      refusal("short.yaml, with_obstacle.yaml",
              "objective:\n  - {metric: obstacle/min_clearance, scenarios: [with_obstacle, short]}\n"),
      AllOf(HasSubstr("objective/0/scenarios"), HasSubstr("does not apply to short;")));
}

TEST_F(StudyOfTwoKindsOfScenario, AConstraintMustApplySomewhere) {
  const std::string objective = "objective: [{metric: gaze/rms}]\nconstraints: ";
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1}]\n"));
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1, "
                                    "scenarios: [short, with_obstacle]}]\n"));
  const std::string both = "short.yaml, with_obstacle.yaml";
  EXPECT_THAT(refusal(both, objective + "[{metric: response/bandwidth, at_least: 5}]\n"),
              AllOf(HasSubstr("constraints/0/metric"),
                    HasSubstr("response/bandwidth does not apply to short, with_obstacle")));
  EXPECT_THAT(
      refusal(both, objective + "[{metric: obstacle/min_clearance, at_least: 0.1, scenarios: [short]}]\n"),
      AllOf(HasSubstr("constraints/0/scenarios"), HasSubstr("does not apply to short")));
}

TEST_F(StudyOfTwoKindsOfScenario, AMetricWithoutADirectionIsNoTermButMayBeBounded) {
  EXPECT_THAT(refusal("short.yaml", "objective:\n  - {metric: joint_velocity/max_ratio_time}\n"),
              AllOf(HasSubstr("joint_velocity/max_ratio_time cannot be an objective")));
  EXPECT_NO_THROW(
      study("objective: [{metric: gaze/rms}, {metric: samples}]\n"
            "constraints: [{metric: joint_velocity/max_ratio_time, at_least: 1}]\n"));
}

}  // namespace study_applies_test
}  // namespace armtune::internal
