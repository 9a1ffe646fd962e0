// From which value on a constraint makes a candidate hopeless, as study files give it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_hopeless_test {

using test::ShortStudy;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

const std::string kEnds =
    "constraints:\n"
    "  - {metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: 1.5}\n"
    "  - {metric: joint_velocity/max_ratio, at_most: start, hopeless: auto}\n"
    "  - {metric: joint_effort/max_ratio, at_most: 1, hopeless: never}\n"
    "  - {metric: joint_position/min_margin, at_least: 0}\n"
    "  - {metric: error/position/rms, at_most: 1}\n";

TEST(StudyFile, ReadsAndWritesFromWhereOnAConstraintIsHopeless) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, kEnds);
  const Study study = load_study(files.path());
  const auto expect_same_ends = [](const Study& s) {
    EXPECT_EQ(s.constraints[0].hopeless.kind, Hopeless::Kind::kFrom);
    EXPECT_EQ(s.constraints[0].hopeless.value, 1.5);
    EXPECT_EQ(s.constraints[1].hopeless.kind, Hopeless::Kind::kAuto);
    EXPECT_EQ(s.constraints[2].hopeless.kind, Hopeless::Kind::kNever);
    EXPECT_EQ(s.constraints[3].hopeless.kind, Hopeless::Kind::kAuto);
    EXPECT_EQ(s.constraints[4].hopeless.kind, Hopeless::Kind::kAuto);
  };
  expect_same_ends(study);
  const std::string text = study_yaml(study, "gains.yaml");
  EXPECT_THAT(text, AllOf(HasSubstr("abandoned from -0.1 on"), HasSubstr("twice the start")));
  const Study again = load_study(files.write("again.yaml", text));
  expect_same_ends(again);
  EXPECT_EQ(study_yaml(again, "gains.yaml"), text);
}

TEST(StudyFile, OnManyArmsOnlyTheWorstMakesACandidateHopeless) {
  const auto with_measure = [](const std::string& measure, const std::string& constraints) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, constraints,
                           "robust: {samples: 2, measure: " + measure + "}\n");
    return load_study(files.path());
  };
  EXPECT_EQ(with_measure("worst", kEnds).constraints[0].hopeless.kind, Hopeless::Kind::kFrom);
  for (const char* measure : {"mean", "quantile", "cvar"}) {
    for (const Constraint& c : with_measure(measure, test::kShortConstraints).constraints) {
      EXPECT_EQ(c.hopeless.kind, Hopeless::Kind::kNever) << measure;
    }
    EXPECT_THAT([&] { return with_measure(measure, kEnds); },
                test::refused_at({.file = EndsWith("study.yaml"),
                                  .line = 11,
                                  .key = "constraints/0/hopeless",
                                  .value = "1.5",
                                  .limit = "never or auto"}));
  }
}

}  // namespace study_hopeless_test
}  // namespace armtune::internal
