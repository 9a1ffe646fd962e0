#include "tuner/study/stiffness_bounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/laws/controller_kind.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace stiffness_bounds_test {

using test::refused_at;
using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Parameter> of_gain(const Study& study, const std::string& gain) {
  std::vector<Parameter> found;
  for (const Parameter& p : study.space.free) {
    if (p.entry.field->name == gain) found.push_back(p);
  }
  return found;
}

// How stiff an arm may become in a contact is the user's to say.
TEST(StiffnessBounds, StiffnessIsNotTunedUnlessItsBoundsAreGiven) {
  const ShortStudy files;
  for (const char* kind : {"impedance", "cartesian_impedance"}) {
    const std::string gain = std::string(kind) + "_k";
    Study study = load_study(files.path(), kind);
    EXPECT_FALSE(study.space.free.empty()) << "the damping is";
    EXPECT_THAT(of_gain(study, gain), IsEmpty());
    EXPECT_THAT(note_on_stiffness(study), AllOf(HasSubstr(gain), HasSubstr("--max-stiffness")));

    const JointVector start = own(study.space.start, gain);
    bound_stiffness({1e7, 1e6}, study);
    const std::vector<Parameter> tuned = of_gain(study, gain);
    ASSERT_EQ(tuned.size(), 6U);
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const double k = start[static_cast<Eigen::Index>(axis)];
      EXPECT_EQ(tuned[axis].start, k);
      EXPECT_DOUBLE_EQ(tuned[axis].lower, 0.2 * k);
      EXPECT_EQ(tuned[axis].upper, axis < 3 ? 1e7 : 1e6);
    }
    EXPECT_THAT(note_on_stiffness(study), IsEmpty());
    const auto twice = [&] { bound_stiffness({1e7, 1e6}, study); };
    EXPECT_THAT(twice, refused_at({.file = files.path(), .key = gain + "/x"}));
  }
}

TEST(StiffnessBounds, AStartAboveItsBoundIsLoweredToIt) {
  const ShortStudy files;
  Study study = load_study(files.path(), "impedance");
  const JointVector start = own(study.space.start, "impedance_k");
  bound_stiffness({0.5 * start[0], 2.0 * start[1], start[2], start[3], start[4], start[5]}, study);
  EXPECT_EQ(own(study.space.start, "impedance_k")[0], 0.5 * start[0]);
  EXPECT_EQ(own(study.space.start, "impedance_k")[1], start[1]);
  EXPECT_EQ(of_gain(study, "impedance_k")[0].start, 0.5 * start[0]);
  EXPECT_EQ(of_gain(study, "impedance_k")[0].upper, 0.5 * start[0]);
}

TEST(StiffnessBounds, JointsTakeOneNumberOrOneForEach) {
  const std::string path = test::source_dir() + "/examples/joint_trajectory/study.yaml";
  Study one = load_study(path, "joint_impedance");
  EXPECT_THAT(note_on_stiffness(one), HasSubstr("joint_impedance_k"));
  bound_stiffness({1e5}, one);
  ASSERT_EQ(of_gain(one, "joint_impedance_k").size(), 6U);
  Study each = load_study(path, "joint_impedance");
  bound_stiffness({1e5, 2e5, 3e5, 4e5, 5e5, 6e5}, each);
  EXPECT_EQ(of_gain(each, "joint_impedance_k")[4].upper, 5e5);
  // Where no task of the tool is followed, the stiffness of its axes does not act.
  Study task = load_study(path, "impedance");
  EXPECT_THAT(note_on_stiffness(task), IsEmpty());
  const auto without_task = [&] { bound_stiffness({1e5, 1e5}, task); };
  EXPECT_THAT(without_task, refused_at({.key = "--max-stiffness", .value = ""}));
}

TEST(StiffnessBounds, WhatDoesNotFitIsRefused) {
  const ShortStudy files;
  const auto refused = [&files](const char* kind, const std::vector<double>& most) {
    return test::input_error([&] {
      Study study = load_study(files.path(), kind);
      bound_stiffness(most, study);
    });
  };
  const InputError none = refused("adaptive", {100.0});
  EXPECT_THAT(none, refused_at({.file = "", .key = "--max-stiffness", .value = ""}));
  EXPECT_THAT(none.what(), HasSubstr("adaptive"));
  EXPECT_THAT(refused("impedance", {100.0}),
              refused_at({.file = "", .key = "--max-stiffness", .value = "1", .limit = "2 or 6 numbers"}));
  // Six joints are not the six axes of a task.
  const InputError joints = refused("joint_impedance", {100.0, 200.0});
  EXPECT_THAT(joints, refused_at({.key = "--max-stiffness", .value = "2", .limit = "1 or 6 numbers"}));
  EXPECT_THAT(joints.what(), HasSubstr("joint_impedance_k has 6"));
  EXPECT_THAT(note_on_stiffness(load_study(files.path())), IsEmpty());
}

TEST(StiffnessBounds, AStudyThatNamesAStiffnessGivesItsUpperBound) {
  const auto study = [](const std::string& bounds) {
    return load_study(
        ShortStudy("controller: impedance\nparameters: [{name: impedance_k/x" + bounds + "}]\n").path());
  };
  EXPECT_THAT([&] { return study(""); },
              refused_at({.line = 5, .key = "parameters/0", .limit = "the key 'upper'"}));
  const Parameter given = study(", upper: 1e5").space.free.front();
  EXPECT_EQ(given.upper, 1e5);
  EXPECT_DOUBLE_EQ(given.lower, 0.2 * given.start);
}

}  // namespace stiffness_bounds_test
}  // namespace armtune::internal
