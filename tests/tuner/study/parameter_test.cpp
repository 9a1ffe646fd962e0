#include "tuner/study/parameter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace parameter_test {

/// Two free gains, one per scale, and one that follows the first.
class Parameters : public testing::Test {
 protected:
  Parameters() {
    const Scenario scenario = test::scenario_of("moving_target");
    joints_ = joint_names(*scenario.robot);
    space_.start = test::published_gains(scenario);
    space_.free = {{entry("task_space_gains_p/rx"), 25.0, 5.0, 80.0, Scale::kLog},
                   {entry("slerpDurationErrorGain"), 2.5, 0.5, 6.5, Scale::kLinear}};
    space_.links = {{entry("task_space_gains_p/ry"), 0, 0.6}};
  }

  GainEntry entry(const std::string& name) const {
    for (const GainEntry& e : gain_entries(space_.start, joints_)) {
      if (e.name == name) return e;
    }
    ADD_FAILURE() << "no gain " << name;
    return {};
  }
  double at(const std::vector<double>& x, const std::string& name) const {
    return value(space_.gains_at(x), entry(name));
  }
  /// The error with which the space is refused after a change to its first parameter.
  template <typename Change>
  InputError refusal_after(Change&& change) const {
    ParameterSpace changed = space_;
    change(changed.free[0]);
    return test::input_error([&] { validate(changed, "study.yaml"); });
  }

  std::vector<std::string> joints_;
  ParameterSpace space_;
};

TEST_F(Parameters, EveryNumberOfEveryFieldHasAnEntryOfItsOwn) {
  Gains gains = space_.start;
  const auto entries = gain_entries(space_.start, joints_);
  for (std::size_t i = 0; i < entries.size(); ++i) value(gains, entries[i]) = 1000.0 + static_cast<double>(i);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(value(gains, entries[i]), 1000.0 + static_cast<double>(i)) << entries[i].name;
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(entries[i].name, entries[j].name);
  }
  EXPECT_EQ(gains.task_space_gains_d[5], value(gains, entry("task_space_gains_d/wrist_3_joint")));
}

TEST_F(Parameters, AForceGainOfEachJointIsAnEntryAndTheOtherFormHasNone) {
  Gains lists = space_.start;
  lists.force_control_gains = ForceGains::LinSpaced(36, 1.0, 36.0);
  std::size_t of_elbow = 0;
  std::size_t of_forces = 0;
  for (const GainEntry& e : gain_entries(lists, joints_)) {
    of_elbow += is_named(e, "force_control_gains/elbow_joint") ? 1 : 0;
    of_forces += is_named(e, "force_control_gains") ? 1 : 0;
    EXPECT_TRUE(has(lists, e)) << e.name;
    EXPECT_EQ(has(space_.start, e), !is_named(e, "force_control_gains")) << e.name;
    if (e.name == "force_control_gains/elbow_joint/shoulder_lift_joint") {
      EXPECT_EQ(value(lists, e), 2 * 6 + 1 + 1);
    }
  }
  EXPECT_EQ(of_elbow, 6U);
  EXPECT_EQ(of_forces, 36U);
  EXPECT_FALSE(has(lists, entry("force_control_gains/elbow_joint")));
}

TEST_F(Parameters, TheUnitBoxSpansTheBoundsOnEachScale) {
  EXPECT_DOUBLE_EQ(at({0.0, 0.0}, "task_space_gains_p/rx"), 5.0);
  EXPECT_DOUBLE_EQ(at({1.0, 1.0}, "task_space_gains_p/rx"), 80.0);
  EXPECT_DOUBLE_EQ(at({0.5, 0.5}, "task_space_gains_p/rx"), 20.0) << "the geometric mean";
  EXPECT_DOUBLE_EQ(at({0.0, 0.0}, "slerpDurationErrorGain"), 0.5);
  EXPECT_DOUBLE_EQ(at({1.0, 1.0}, "slerpDurationErrorGain"), 6.5);
  EXPECT_DOUBLE_EQ(at({0.5, 0.5}, "slerpDurationErrorGain"), 3.5) << "the arithmetic mean";
}

TEST_F(Parameters, CoordinatesOfGainsLeadBackToThem) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<double> x = {unit(generator), unit(generator)};
    const std::vector<double> back = space_.point_of(space_.gains_at(x));
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(back[k], x[k], 1e-14);
  }
}

TEST_F(Parameters, TheStartIsKeptToTheBit) {
  const Gains gains = space_.gains_at(space_.start_point());
  EXPECT_EQ(gains.task_space_gains_p[3], 25.0);
  EXPECT_EQ(gains.slerpDurationErrorGain, 2.5);
}

TEST_F(Parameters, BoundsHoldForCoordinatesAndGainsOutsideThem) {
  EXPECT_EQ(at({-3.0, 7.0}, "task_space_gains_p/rx"), 5.0);
  EXPECT_EQ(at({-3.0, 7.0}, "slerpDurationErrorGain"), 6.5);
  Gains wild = space_.start;
  wild.task_space_gains_p[3] = 1e6;
  wild.slerpDurationErrorGain = 0.1;
  EXPECT_EQ(space_.point_of(wild), (std::vector<double>{1.0, 0.0}));
}

TEST_F(Parameters, ALinkedGainFollowsByItsFactorAndTheOthersStay) {
  for (const double x : {0.0, 0.3, 1.0}) {
    const Gains gains = space_.gains_at({x, 0.2});
    EXPECT_DOUBLE_EQ(gains.task_space_gains_p[4], 0.6 * gains.task_space_gains_p[3]);
    EXPECT_EQ(gains.task_space_gains_p[5], space_.start.task_space_gains_p[5]);
    EXPECT_EQ(gains.task_space_gains_d, space_.start.task_space_gains_d);
  }
}

TEST_F(Parameters, WhatDoesNotFitIsRefusedByName) {
  EXPECT_NO_THROW(validate(space_, "study.yaml"));
  const auto with = [](const std::string& value, const std::string& limit) {
    return test::refused_at(
        {.file = "study.yaml", .key = "task_space_gains_p/rx", .value = value, .limit = limit});
  };
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = 90.0; }), with("90", "below the upper bound 80"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = p.upper; }), with("80", "below the upper bound 80"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = p.upper = p.start = 0.0; }),
              with("0", "above zero, or with bounds"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.upper = HUGE_VAL; }), with("inf", "finite"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = std::nan(""); }),
              with("nan", "below the upper bound 80"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = -1.0; }), with("-1", "not negative"));
  EXPECT_THAT(refusal_after([](Parameter& p) { p.lower = 0.0; }), with("0", "above zero"));
  const InputError low = refusal_after([](Parameter& p) { p.start = 4.9; });
  EXPECT_THAT(low, with("4.9", "5 to 80"));
  EXPECT_STREQ(low.what(),
               "study.yaml: parameter task_space_gains_p/rx: start 4.9 lies outside its bounds 5 .. 80; give "
               "a 'start' between them, or other bounds");
  EXPECT_THAT(refusal_after([](Parameter& p) { p.start = std::nan(""); }), with("nan", "5 to 80"));
  EXPECT_THAT([] { validate(ParameterSpace{}, "study.yaml"); }, test::refused_at({.file = "study.yaml"}));
}

TEST_F(Parameters, BoundsThatAreAcceptedGiveFiniteGainsEverywhere) {
  int accepted = 0;
  for (const double lower : {2.3e-308, 1e-200, 1e-100, 1e-20, 1e-6, 1.0}) {
    for (const double upper : {25.0, 80.0, 1e6, 1e100, 1.7e308}) {
      ParameterSpace space = space_;
      space.free[0].lower = lower;
      space.free[0].upper = upper;
      const InputError error = test::input_error([&] { validate(space, "study.yaml"); });
      if (!error.place().file.empty()) {
        EXPECT_THAT(error, test::refused_at({.file = "study.yaml", .key = "task_space_gains_p/rx"}));
        continue;
      }
      ++accepted;
      for (const double x : {0.0, 0.3, 0.5, 1.0}) {
        EXPECT_TRUE(std::isfinite(value(space.gains_at({x, 0.5}), space.free[0].entry)))
            << lower << " " << upper;
      }
      EXPECT_DOUBLE_EQ(value(space.gains_at({0.0, 0.5}), space.free[0].entry), lower);
      EXPECT_DOUBLE_EQ(value(space.gains_at({1.0, 0.5}), space.free[0].entry), upper);
    }
  }
  EXPECT_GT(accepted, 5);
}

}  // namespace parameter_test
}  // namespace armtune::internal
