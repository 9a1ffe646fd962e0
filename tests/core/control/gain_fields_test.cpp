#include "core/control/gain_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "armtune/error.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace gain_fields_test {

using test::refused_at;

/// The error of validate for a UR10's gains after one change, and its message.
InputError error_of(const std::function<void(Gains&)>& change) {
  Gains gains = test::ur10_gains();
  change(gains);
  return test::input_error([&] { validate(gains, joint_names(test::ur10()), "gains.yaml"); });
}
std::string refusal_of(const std::function<void(Gains&)>& change) {
  return error_of(change).what();
}

void set(Gains& gains, const GainField& field, std::size_t index, double value) {
  numbers(gains, field)[index] = value;
}

TEST(GainFields, NamesAreDeclaredOnce) {
  std::set<std::string> names;
  for (const GainField& field : gain_fields()) EXPECT_TRUE(names.insert(field.name).second) << field.name;
}

TEST(GainFields, NumbersAreOnePerComponentName) {
  Gains gains = test::ur10_gains();
  const std::vector<std::string> joints = joint_names(test::ur10());
  for (const GainField& field : gain_fields()) {
    if (!field.is_number()) {
      EXPECT_TRUE(numbers(gains, field).empty()) << field.name;
      continue;
    }
    EXPECT_EQ(numbers(gains, field).size(), component_names(field, joints).size()) << field.name;
  }
}

TEST(GainFields, NumbersAreTheGainsOwnMemory) {
  Gains gains = test::ur10_gains();
  for (const GainField& field : gain_fields()) {
    if (std::string(field.name) == "task_space_gains_i") set(gains, field, 4, 0.77);
  }
  EXPECT_EQ(gains.task_space_gains_i[4], 0.77);
}

TEST(GainFields, PublishedGainsAreValid) {
  EXPECT_EQ(refusal_of([](Gains&) {}), "nothing was refused");
}

TEST(GainFields, EveryNumberMustBeFiniteAndTheRefusalNamesTheGain) {
  for (const GainField& field : gain_fields()) {
    const std::size_t count = [&] {
      Gains gains = test::ur10_gains();
      return numbers(gains, field).size();
    }();
    for (std::size_t i = 0; i < count; ++i) {
      for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(error_of([&](Gains& gains) { set(gains, field, i, bad); }),
                    refused_at({.file = "gains.yaml",
                                .key = field.name,
                                .value = std::isnan(bad) ? "nan" : "inf",
                                .limit = testing::StartsWith("finite and ")}));
      }
    }
  }
}

TEST(GainFields, NoNumberButTheJointGoalMayBeNegative) {
  for (const GainField& field : gain_fields()) {
    if (!field.is_number()) continue;
    const InputError error = error_of([&](Gains& gains) { set(gains, field, 0, -1.25); });
    if (std::string(field.name) == "joint_space_goal") {
      EXPECT_STREQ(error.what(), "nothing was refused");
    } else {
      EXPECT_THAT(error, refused_at({.key = field.name, .value = "-1.25"}));
    }
  }
}

TEST(GainFields, ZeroIsRefusedExactlyWhereAFieldIsStrictlyPositive) {
  for (const GainField& field : gain_fields()) {
    if (!field.is_number()) continue;
    const std::string message = refusal_of([&](Gains& gains) { set(gains, field, 0, 0.0); });
    EXPECT_EQ(message == "nothing was refused", !field.strictly_positive) << field.name << ": " << message;
  }
}

TEST(GainFields, TheRefusalNamesTheComponent) {
  EXPECT_THAT(refusal_of([](Gains& gains) { gains.task_space_gains_p[3] = -2.0; }),
              testing::StartsWith("gains.yaml: task_space_gains_p/rx is -2; it must be finite and "));
  EXPECT_THAT(refusal_of([](Gains& gains) { gains.task_space_gains_d[2] = -2.0; }),
              testing::StartsWith("gains.yaml: task_space_gains_d/elbow_joint is -2; "));
}

TEST(GainFields, AWrongNumberOfJointGainsIsRefusedWithBothNumbers) {
  EXPECT_THAT(error_of([](Gains& gains) { gains.force_control_gains = JointVector::Ones(5); }),
              refused_at({.key = "force_control_gains", .value = "5", .limit = "6 values"}));
}

TEST(GainFields, GainsOfForcesAreOnePerForcePointOrOnePerForcePointAndJoint) {
  const auto with = [](Eigen::Index count) {
    return [count](Gains& gains) { gains.force_control_gains = ForceGains::Ones(count); };
  };
  EXPECT_EQ(refusal_of(with(6)), "nothing was refused");
  EXPECT_EQ(refusal_of(with(36)), "nothing was refused");
  for (const Eigen::Index count : {0, 1, 12, 35, 37}) {
    EXPECT_THAT(error_of(with(count)),
                refused_at({.key = "force_control_gains", .value = std::to_string(count)}));
  }
  EXPECT_THAT(refusal_of([](Gains& gains) {
                gains.force_control_gains = ForceGains::Ones(36);
                gains.force_control_gains[2 * 6 + 1] = -2.0;
              }),
              testing::StartsWith("gains.yaml: force_control_gains/elbow_joint/shoulder_lift_joint is -2"));
}

TEST(GainFields, ReleaseRadiusIsZeroOrAtLeastTheInfluenceRadius) {
  EXPECT_EQ(refusal_of([](Gains& gains) { gains.release_radius = gains.obstacleInfluenceRadius; }),
            "nothing was refused");
  EXPECT_THAT(error_of([](Gains& gains) { gains.release_radius = 0.3; }),
              refused_at({.key = "release_radius", .value = "0.3", .limit = "0 or at least 0.325"}));
}

TEST(GainFields, ASlerpMustStartBeforeItsEnd) {
  EXPECT_EQ(refusal_of([](Gains& gains) { gains.slerp_start = 0.999; }), "nothing was refused");
  EXPECT_THAT(error_of([](Gains& gains) { gains.slerp_start = 1.0; }),
              refused_at({.key = "slerp_start", .value = "1", .limit = "below 1"}));
}

}  // namespace gain_fields_test
}  // namespace armtune::internal
