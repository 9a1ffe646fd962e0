#include "core/control/laws/controller_kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "armtune/error.hpp"
#include "core/control/laws/controller.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/law_period.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace controller_kind_test {

using test::refused_at;

/// The error with which register_controller refuses a kind.
InputError refusal_of(ControllerKind kind) {
  return test::input_error([&] { register_controller(std::move(kind)); });
}

class NoLaw final : public TorqueLaw {
 public:
  using TorqueLaw::TorqueLaw;
  void torque(const LawInput& in, JointVector& tau) override { tau.setZero(in.measured.q.size()); }
};

ControllerKind named(const char* name) {
  ControllerKind kind;
  kind.name = name;
  kind.meaning = "nothing";
  kind.make = [](const LawSetup& setup) { return std::make_unique<NoLaw>(setup); };
  return kind;
}

TEST(ControllerKind, OfArmtuneAreNine) {
  std::vector<std::string> names;
  for (const ControllerKind* kind : controller_kinds()) names.push_back(kind->name);
  ASSERT_GE(names.size(), 9U);
  names.resize(9);
  EXPECT_THAT(names,
              testing::ElementsAre("adaptive", "joint_pd", "computed_torque", "impedance", "joint_impedance",
                                   "cartesian_impedance", "joint_trajectory_controller",
                                   "joint_trajectory_controller_velocity", "position_streaming"));
}

TEST(ControllerKind, AdaptiveHasEveryMemberOfGainsInTheirOrder) {
  const auto& fields = fields_of(Gains());
  ASSERT_EQ(fields.size(), gain_fields().size());
  for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_STREQ(fields[i].name, gain_fields()[i].name);
}

TEST(ControllerKind, EveryKindHasAllGainsThatAreNoLawsAndItsOwnLast) {
  for (const ControllerKind* kind : controller_kinds()) {
    std::set<std::string> names;
    for (const GainField& field : fields_of(*kind))
      EXPECT_TRUE(names.insert(field.name).second) << field.name;
    for (const GainField& field : gain_fields()) {
      const bool named = std::find(kind->uses.begin(), kind->uses.end(), field.name) != kind->uses.end();
      EXPECT_EQ(names.count(field.name) == 1, !field.of_law || named) << kind->name << ' ' << field.name;
    }
    for (std::size_t i = 0; i < kind->own.size(); ++i) {
      EXPECT_STREQ((fields_of(*kind).end() - static_cast<long>(kind->own.size() - i))->name,
                   kind->own[i].name);
    }
  }
}

TEST(ControllerKind, WhatCannotBeIsRefusedByName) {
  EXPECT_THAT(refusal_of(named("adaptive")), refused_at({.value = "adaptive", .limit = "another name"}));
  EXPECT_THAT(refusal_of(named("two words")),
              refused_at({.value = "two words", .limit = "letters, digits and underscores"}));
  ControllerKind kind = named("lawless");
  kind.make = nullptr;
  EXPECT_THAT(refusal_of(kind), refused_at({}));
  kind = named("wishful");
  kind.uses = {"release_radius"};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "release_radius"}));
  kind.uses = {};
  kind.own = {own_gain(GainShape::kScalar, "task_space_gains_p", "1", "taken", 1.0)};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "task_space_gains_p"}));
  kind.own = {own_gain(GainShape::kScalar, "twice", "1", "a", 1.0),
              own_gain(GainShape::kTask, "twice", "1", "b", 1.0)};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "twice", .limit = "another name"}));
  kind.own = {own_gain(GainShape::kScalar, "controller", "1", "a key of the file", 1.0)};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "controller"}));
  kind.own = {own_gain(GainShape::kScalar, "negative", "1", "a", -1.0)};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "-1", .limit = "finite and not negative"}));
  kind.own = {positive(own_gain(GainShape::kScalar, "zero", "1", "a", 0.0))};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "0", .limit = "finite and above zero"}));
  kind.own = {own_gain(GainShape::kScalar, "narrow", "1", "a", 1.0, 2.0, 2.0)};
  EXPECT_THAT(refusal_of(kind), refused_at({.value = "2 to 2"}));
  kind.own = {gain_fields().front()};
  EXPECT_THAT(refusal_of(kind), testing::Property(&InputError::what, testing::HasSubstr("own_gain")));
  EXPECT_THAT([] { controller_kind("adaptiv"); },
              refused_at({.value = "adaptiv", .limit = testing::StartsWith("one of: adaptive, joint_pd, ")}));
}

TEST(ControllerKind, GainsOfOneKindBecomeValidGainsOfEveryOther) {
  const test::Rig rig;
  const std::vector<std::string> joints = joint_names(*rig.model);
  for (const ControllerKind* from : controller_kinds()) {
    const Gains gains = convert_gains(*from, rig.gains, *rig.model, rig.goal().q);
    for (const ControllerKind* to : controller_kinds()) {
      const Gains other = convert_gains(*to, gains, *rig.model, rig.goal().q);
      EXPECT_EQ(other.controller, to->name);
      EXPECT_NO_THROW(validate(other, joints, to->name)) << from->name;
      EXPECT_EQ(other.joint_space_gains_d, rig.gains.joint_space_gains_d);
      EXPECT_EQ(other.own.size(), to->own.size());
    }
  }
}

TEST(ControllerKind, AGainThatTheKindDoesNotHaveDoesNotAct) {
  const test::Rig rig;
  const Gains gains = convert_gains(controller_kind("impedance"), rig.gains, *rig.model, rig.goal().q);
  EXPECT_TRUE(gains.task_space_gains_p.isZero(0.0));
  EXPECT_TRUE(gains.task_space_gains_i.isZero(0.0));
  EXPECT_EQ(gains.task_space_gains_d.size(), 0);
  EXPECT_EQ(gains.interpolation_gain_scale, 1.0);
  EXPECT_EQ(gains.adaptation_gain, 0.0);
  EXPECT_EQ(gains.adaptation_leakage, 0.0);
  EXPECT_FALSE(gains.adaptation_projection);
}

TEST(ControllerKind, WhatTheOtherKindDidNotHaveBeginsWithTheArmsInertia) {
  const test::Rig rig;
  const JointVector q = rig.goal().q;
  const Gains impedance = convert_gains(controller_kind("impedance"), rig.gains, *rig.model, q);
  const Gains adaptive = convert_gains(controller_kind("adaptive"), impedance, *rig.model, q);
  EXPECT_GT(adaptive.task_space_gains_p.minCoeff(), 0.0);
  ASSERT_EQ(adaptive.task_space_gains_d.size(), 6);
  EXPECT_LT((adaptive.task_space_gains_d - kFirstRate * joint_inertia(*rig.model, q)).norm(), 1e-9);
}

TEST(ControllerKind, OwnGainsAreFoundByNameAndCheckedLikeAnyOther) {
  Gains gains =
      convert_gains(controller_kind("joint_pd"), test::ur10_gains(), test::ur10(), test::Rig().goal().q);
  EXPECT_EQ(own(gains, "joint_pd_p").size(), 6);
  EXPECT_THROW(own(gains, "impedance_k"), InputError);
  own(gains, "joint_pd_p")[2] = -3.0;
  EXPECT_THAT([&] { validate(gains, joint_names(test::ur10()), "gains.yaml"); },
              refused_at({.file = "gains.yaml", .key = "joint_pd_p", .value = "-3"}));
  own(gains, "joint_pd_p").resize(5);
  EXPECT_THROW(validate(gains, joint_names(test::ur10()), "gains.yaml"), InputError);
  gains.own.clear();
  EXPECT_THROW(validate(gains, joint_names(test::ur10()), "gains.yaml"), InputError);
}

// Before a law is added: the torque that a law commands is the one that leaves the controller, to the limits.
TEST(ControllerKind, TheControllersTorqueIsThatOfTheLawTheGainsName) {
  test::Rig rig;
  for (const ControllerKind* kind : controller_kinds()) {
    if (!kind->start && !kind->own.empty()) continue;  // of another test
    rig.gains = convert_gains(*kind, test::ur10_gains(), *rig.model, rig.goal().q);
    double time = 0.0;
    const auto controller = rig.following(time);
    JointState measured = rig.goal();
    measured.qd[2] = 0.1;
    const ControlOutput& out = controller->update(measured, rig.scene(), time);
    ASSERT_EQ(out.state, ControlState::kFollowTrajectory) << kind->name;
    EXPECT_NE(out.commanded, JointVector::Zero(6)) << kind->name;
    // Towards rest: the third joint is slowed down by all of them.
    const JointVector still = rig.controller()->update(rig.goal(), rig.scene(), 0.0).commanded;
    EXPECT_LT(out.commanded[2], still[2]) << kind->name;
  }
}

}  // namespace controller_kind_test
}  // namespace armtune::internal
