// Which models validate() refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <limits>

#include "core/robot/robot_model.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace model_checks_test {

using test::refused_at;

/// The error with which `validate` refuses the seven-joint arm after one change.
InputError error_of(const std::function<void(RobotModel&)>& change) {
  RobotModel model = test::seven_joint_arm();
  change(model);
  return test::input_error([&] { validate(model); });
}

TEST(Validate, AcceptsAllTestArms) {
  const std::vector<RobotModel> arms = test::all_arms();
  ASSERT_EQ(arms.size(), 6u);
  for (const RobotModel& arm : arms) EXPECT_NO_THROW(validate(arm)) << arm.name;
}

TEST(Validate, RefusesALinkWithoutMass) {
  EXPECT_THAT(
      error_of([](RobotModel& m) { m.chain.link[2].mass = 0.0; }),
      refused_at(
          {.file = "seven_joint_arm", .key = "link_3/mass", .value = "0", .limit = "finite and above 0"}));
}

TEST(Validate, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.link[0].mass = nan; }),
              refused_at({.key = "link_1/mass", .value = "nan"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.link[1].first_moment.x() = inf; }),
              refused_at({.key = "link_2/inertia", .limit = "finite"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.link[1].inertia(1, 1) = nan; }),
              refused_at({.key = "link_2/inertia", .limit = "finite"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.p_PB0[3].y() = nan; }),
              refused_at({.key = "joint_4/origin", .limit = "finite"}));
  const std::string tip = test::seven_joint_arm().tip_link;
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.R_BT(0, 0) = nan; }),
              refused_at({.key = tip + "/origin", .limit = "finite"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.chain.gravity.z() = nan; }),
              refused_at({.key = "gravity", .limit = "finite"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.joints[4].limits.velocity = inf; }),
              refused_at({.key = "joint_5/velocity", .value = "inf"}));
  EXPECT_THAT(error_of([&](RobotModel& m) { m.joints[4].limits.upper = inf; }),
              refused_at({.key = "joint_5/upper", .value = "inf", .limit = "finite"}));
}

/// The error for the seven-joint arm with this inertia about the centre of mass of its last link.
InputError error_of_moments(const Vec3& moments) {
  return error_of([&](RobotModel& m) {
    LinkInertia principal;
    principal.mass = 0.3;
    principal.inertia = moments.asDiagonal();
    const Mat3 R = Eigen::AngleAxisd(0.8, Vec3(1, 1, -2).normalized()).toRotationMatrix();
    m.chain.link[6] = in_frame(principal, R, Vec3(0.01, 0.0, 0.2));
  });
}

TEST(Validate, RefusesInertiaNoBodyCanHave) {
  EXPECT_THAT(error_of_moments({0.01, 0.01, -0.001}),
              refused_at({.key = "link_7/inertia", .value = testing::HasSubstr("-0.001")}));
  EXPECT_THAT(error_of_moments({0.01, 0.01, 0.03}),
              refused_at({.key = "link_7/inertia", .value = testing::HasSubstr("0.03")}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.link[5].inertia(0, 1) += 0.01; }),
              refused_at({.key = "link_6/inertia", .limit = "symmetric"}));
}

TEST(Validate, AcceptsThinPlatesRoundedToFiveDigitsAndPointMasses) {
  EXPECT_STREQ(error_of_moments({0.012345, 0.023456, 0.035802}).what(), "nothing was refused");
  EXPECT_STREQ(error_of_moments({0.0, 0.0, 0.0}).what(), "nothing was refused");
}

TEST(Validate, RefusesARevoluteLinkWithoutInertiaAboutItsAxis) {
  EXPECT_THAT(
      error_of([](RobotModel& m) {
        m.chain.link[6].first_moment = Vec3(0.0, 0.0, 0.01);
        m.chain.link[6].inertia = Vec3(0.001, 0.001, 0.0).asDiagonal();
      }),
      refused_at({.key = "link_7/inertia", .value = "0", .limit = "above 0 about the axis of the joint"}));
}

TEST(Validate, RefusesLimitsThatAreMissingOrCrossed) {
  EXPECT_THAT(
      error_of([](RobotModel& m) { m.joints[1].limits.lower = 2.5; }),
      refused_at({.key = "joint_2/lower", .value = "2.5", .limit = testing::StartsWith("below 2.09")}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints[1].limits.lower = m.joints[1].limits.upper; }),
              refused_at({.key = "joint_2/lower", .limit = testing::StartsWith("below 2.09")}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints[1].limits.velocity = 0.0; }),
              refused_at({.key = "joint_2/velocity", .value = "0", .limit = "finite and above 0"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints[1].limits.effort = -3.0; }),
              refused_at({.key = "joint_2/effort", .value = "-3", .limit = "finite and above 0"}));
}

TEST(Validate, RefusesNegativeRotorInertiaAndFriction) {
  const std::string limit = "finite and 0 or more";
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.rotor_inertia[2] = -0.1; }),
              refused_at({.key = "joint_3/rotor_inertia", .value = "-0.1", .limit = limit}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.viscous_friction[2] = -0.1; }),
              refused_at({.key = "joint_3/viscous_friction", .value = "-0.1", .limit = limit}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.coulomb_friction[2] = -0.1; }),
              refused_at({.key = "joint_3/coulomb_friction", .value = "-0.1", .limit = limit}));
}

TEST(Validate, RefusesShapesThatDoNotFit) {
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.n = 0; }),
              refused_at({.key = "joints", .value = "0", .limit = "at least 1"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.n = kMaxJoints + 1; }),
              refused_at({.key = "joints", .value = "13", .limit = "at most 12"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints.pop_back(); }),
              refused_at({.key = "joints", .limit = "one entry for each joint"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.chain.R_PB0[1] *= 1.1; }),
              refused_at({.key = "joint_2/origin", .limit = "a rotation matrix"}));
}

TEST(Validate, RefusesNamesThatWouldBreakACsvHeader) {
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints[0].name = "a,b"; }),
              refused_at({.key = "joint", .value = "a,b"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.joints[0].link = ""; }),
              refused_at({.key = "link", .value = "", .limit = "a name"}));
  EXPECT_THAT(error_of([](RobotModel& m) { m.name = ""; }),
              refused_at({.key = "robot", .value = "", .limit = "a name"}));
}

}  // namespace model_checks_test
}  // namespace armtune::internal
