#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace warm_study_file_test {

using test::refused_at;
using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;

class WarmStudyFile : public testing::Test {
 protected:
  /// Writes the study with this warm start and gives its path.
  std::string with(const std::string& warm) const {
    return files_.write("warm.yaml", test::read_text(files_.path()) + "warm_start:\n  " + warm + "\n");
  }
  /// Returns the error with which a warm start is refused. Its first key is in line 16 of the study.
  InputError refusal(const std::string& warm) const {
    const std::string path = with(warm);
    InputError error = test::input_error([&] { load_study(path); });
    EXPECT_THAT(error, refused_at({.file = path, .key = testing::StartsWith("warm_start")}));
    return error;
  }
  /// A gains file, the study's own but for the two that are tuned.
  void gains(const std::string& name, double rx, double slerp) const {
    Gains gains = load_study(files_.path()).space.start;
    gains.task_space_gains_p[3] = rx;
    gains.slerpDurationErrorGain = slerp;
    files_.write(name, gains_yaml(gains, {}));
  }

  ShortStudy files_;
};

TEST_F(WarmStudyFile, BeginsAtTheGainsOfAFileOrARunFolder) {
  gains("other.yaml", 40.0, 3.0);
  std::filesystem::create_directories(files_ / "run");
  gains("run/gains.yaml", 40.0, 3.0);
  for (const char* from : {"from: other.yaml", "from: run"}) {
    const Study study = load_study(with(from));
    ASSERT_TRUE(study.warm);
    const WarmPoint point = warm_point(study.space, *study.warm);
    const Gains there = study.space.gains_at(point.x);
    EXPECT_NEAR(there.task_space_gains_p[3], 40.0, 1e-12);
    EXPECT_NEAR(there.slerpDurationErrorGain, 3.0, 1e-12);
    EXPECT_EQ(study.space.start.task_space_gains_p[3], 25.0) << "the start stays the start";
    EXPECT_EQ(point.lower, (std::vector<double>{0.0, 0.0}));
    EXPECT_EQ(point.upper, (std::vector<double>{1.0, 1.0}));
    EXPECT_TRUE(point.clamped.empty());
  }
}

TEST_F(WarmStudyFile, NamedParametersComeFromThereTheOthersFromTheStart) {
  gains("other.yaml", 40.0, 3.0);
  for (const char* name : {"task_space_gains_p/rx", "task_space_gains_p"}) {
    const Study study = load_study(with(std::string("from: other.yaml\n  parameters: [") + name + "]"));
    const Gains there = study.space.gains_at(warm_point(study.space, *study.warm).x);
    EXPECT_NEAR(there.task_space_gains_p[3], 40.0, 1e-12);
    EXPECT_EQ(there.slerpDurationErrorGain, study.space.start.slerpDurationErrorGain);
  }
}

TEST_F(WarmStudyFile, ItsBoxIsAPartOfTheRangeAroundThePointAndEndsAtTheBounds) {
  gains("other.yaml", 60.0, 2.5);  // the upper bound, and the middle
  const Study study = load_study(with("from: other.yaml\n  box: 0.3"));
  const WarmPoint point = warm_point(study.space, *study.warm);
  EXPECT_EQ(point.upper[0], 1.0);
  EXPECT_DOUBLE_EQ(point.lower[0], 0.85);
  EXPECT_DOUBLE_EQ(point.lower[1], 0.35);
  EXPECT_DOUBLE_EQ(point.upper[1], 0.65);
}

TEST_F(WarmStudyFile, GainsOutsideTheBoundsBeginAtTheNearerAndAreNamed) {
  gains("other.yaml", 400.0, 0.5);
  const Study study = load_study(with("from: other.yaml"));
  const WarmPoint point = warm_point(study.space, *study.warm);
  EXPECT_EQ(point.x, (std::vector<double>{1.0, 0.0}));
  ASSERT_EQ(point.clamped.size(), 2U);
  EXPECT_THAT(point.clamped[0], AllOf(HasSubstr("other.yaml"), HasSubstr("task_space_gains_p/rx is 400"),
                                      HasSubstr("10 .. 60")));
}

TEST_F(WarmStudyFile, ReadsBackFromItsResolvedFormWithTheGainsKeptBesideIt) {
  gains("other.yaml", 40.0, 3.0);
  const ShortStudy searched(
      test::kShortParameters, test::kShortObjective, test::kShortConstraints,
      "search: {algorithm: SLSQP, global: ISRES, global_share: 0.3, starts: 3, differences: central,\n"
      "         difference_step: 0.02}\n"
      "warm_start: {from: other.yaml, parameters: [task_space_gains_p], box: 0.4, step: 0.07}\n");
  searched.write("other.yaml", test::read_text(files_ / "other.yaml"));
  const Study study = load_study(searched.path());
  files_.write("kept.yaml", gains_yaml(study.warm->gains, {}));
  const std::string text = study_yaml(study, "gains.yaml", "kept.yaml");
  std::filesystem::remove(files_ / "other.yaml");
  std::filesystem::remove(searched / "other.yaml");
  const Study again = load_study(files_.write("resolved.yaml", text));
  EXPECT_EQ(study_yaml(again, "gains.yaml", "kept.yaml"), text);
  const WarmPoint a = warm_point(study.space, *study.warm);
  const WarmPoint b = warm_point(again.space, *again.warm);
  EXPECT_EQ(b.x, a.x);
  EXPECT_EQ(b.lower, a.lower);
  EXPECT_EQ(b.upper, a.upper);
  EXPECT_EQ(again.warm->step, 0.07);
  EXPECT_EQ(again.global_algorithm, "ISRES");
  EXPECT_EQ(again.global_share, 0.3);
  EXPECT_EQ(again.starts, 3U);
  EXPECT_EQ(again.solver.differences, Differences::kCentral);
  EXPECT_EQ(again.solver.difference_step, 0.02);
  EXPECT_FALSE(load_study(files_.write("cold.yaml", study_yaml(study, "gains.yaml"))).warm);
}

TEST_F(WarmStudyFile, ATunedGainThatTheWarmGainsLeaveOutIsRefusedUnlessOthersAreNamed) {
  const Study study = load_study(files_.path());
  ParameterSpace space = study.space;
  for (const GainEntry& entry : gain_entries(study.space.start, joint_names(*study.scenarios[0].robot))) {
    if (std::string(entry.field->name) == "joint_space_goal" && entry.component == 0)
      space.free.push_back({entry, value(space.start, entry), -180.0, 180.0, Scale::kLinear});
  }
  ASSERT_EQ(space.free.size(), 3U);
  WarmStart warm;
  warm.source = "other.yaml";
  warm.gains = space.start;
  warm.gains.task_space_gains_p[3] = 40.0;
  warm.gains.joint_space_goal.resize(0);
  EXPECT_THAT([&] { return warm_point(space, warm); },
              refused_at({.file = "other.yaml", .line = 0, .key = space.free.back().entry.name}));
  warm.parameters = {"task_space_gains_p"};
  const WarmPoint point = warm_point(space, warm);
  EXPECT_NEAR(space.gains_at(point.x).task_space_gains_p[3], 40.0, 1e-12);
  EXPECT_EQ(point.x[2], space.start_point()[2]);
}

TEST_F(WarmStudyFile, WhatCannotBeBegunAtIsRefused) {
  gains("other.yaml", 40.0, 3.0);
  EXPECT_THAT(refusal("from: nowhere.yaml"),
              refused_at({.line = 16, .key = "warm_start/from", .value = "nowhere.yaml"}));
  EXPECT_THAT(refusal("box: 0.5"), refused_at({.line = 15, .key = "warm_start", .limit = "the key 'from'"}));
  const InputError untuned = refusal("from: other.yaml\n  parameters: [task_space_gains_p, adaptation_gain]");
  EXPECT_THAT(untuned, refused_at({.line = 17,
                                   .key = "warm_start/parameters/1",
                                   .value = "adaptation_gain",
                                   .limit = "one of: task_space_gains_p/rx, slerpDurationErrorGain"}));
  const InputError misspelt = refusal("from: other.yaml\n  parameters: [task_space_gains_p/rxx]");
  EXPECT_THAT(misspelt,
              refused_at({.line = 17, .key = "warm_start/parameters/0", .value = "task_space_gains_p/rxx"}));
  EXPECT_EQ(test::suggested_by(misspelt), "task_space_gains_p/rx");
  EXPECT_THAT(refusal("from: other.yaml\n  parameters: []"),
              refused_at({.line = 17, .key = "warm_start/parameters", .value = ""}));
  EXPECT_THAT(refusal("from: other.yaml\n  box: 0"),
              refused_at({.line = 17, .key = "warm_start/box", .value = "0", .limit = "above 0"}));
  EXPECT_THAT(refusal("from: other.yaml\n  box: 2"),
              refused_at({.line = 17, .key = "warm_start/box", .value = "2", .limit = "0 to 1"}));
  EXPECT_THAT(refusal("from: other.yaml\n  step: 0.9"),
              refused_at({.line = 17, .key = "warm_start/step", .value = "0.9", .limit = "1e-06 to 0.5"}));
  const InputError unknown = refusal("from: other.yaml\n  boxes: 0.9");
  EXPECT_THAT(unknown, refused_at({.line = 17, .key = "warm_start/boxes", .value = "boxes"}));
  EXPECT_EQ(test::suggested_by(unknown), "box");
}

}  // namespace warm_study_file_test
}  // namespace armtune::internal
