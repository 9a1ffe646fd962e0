#include "core/robot/robot_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "core/robot/kinematics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace robot_model_test {

TEST(RobotModel, TheSameSeedGivesTheSameArm) {
  const RobotModel a = test::random_arm(6, 3, true);
  const RobotModel b = test::random_arm(6, 3, true);
  EXPECT_EQ(theta_of(a.chain), theta_of(b.chain));
  EXPECT_NE(theta_of(a.chain), theta_of(test::random_arm(6, 4, true).chain));
}

TEST(RobotModel, JointIsFoundByName) {
  const RobotModel arm = test::ur10();
  EXPECT_EQ(arm.joint_index("shoulder_pan_joint"), 0);
  EXPECT_EQ(arm.joint_index("wrist_3_joint"), 5);
}

TEST(RobotModel, UnknownJointIsRefusedWithTheListOfJoints) {
  const RobotModel arm = test::ur10();
  EXPECT_THAT([&] { arm.joint_index("elbow"); },
              test::refused_at({.file = arm.source,
                                .key = "joint",
                                .value = "elbow",
                                .limit = "one of: shoulder_pan_joint, shoulder_lift_joint, elbow_joint, "
                                         "wrist_1_joint, wrist_2_joint, wrist_3_joint"}));
}

TEST(RobotModel, LimitsComeJointByJoint) {
  const RobotModel arm = test::ur10();
  JointVector velocity(6);
  velocity << 2.16, 2.16, 3.15, 3.2, 3.2, 3.2;
  JointVector effort(6);
  effort << 330, 330, 150, 56, 56, 56;
  EXPECT_EQ(arm.velocity_limits(), velocity);
  EXPECT_EQ(arm.effort_limits(), effort);
}

TEST(ThetaNames, NameEveryEntryInItsOrder) {
  const RobotModel arm = test::ur10();
  const std::vector<std::string> names = theta_names(arm);
  const ParameterVector theta = theta_of(arm.chain);
  ASSERT_EQ(static_cast<Eigen::Index>(names.size()), theta.size());
  const auto value = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    return theta[found - names.begin()];
  };
  const LinkInertia& upper_arm = arm.chain.link[1];
  EXPECT_EQ(value("upper_arm_link/mass"), 12.93);
  EXPECT_EQ(value("upper_arm_link/my"), upper_arm.first_moment.y());
  EXPECT_EQ(value("upper_arm_link/ixz"), upper_arm.inertia(0, 2));
  EXPECT_EQ(value("upper_arm_link/izz"), upper_arm.inertia(2, 2));
  EXPECT_EQ(value("elbow_joint/rotor_inertia"), 0.1);
  EXPECT_EQ(names.back(), "wrist_3_joint/coulomb_friction");
}

TEST(Reach, IsNeverExceededByTheTool) {
  std::mt19937 generator(1);
  for (const RobotModel& arm : test::all_arms()) {
    double farthest = 0.0;
    for (int sample = 0; sample < 200; ++sample) {
      JointVector q(arm.n());
      for (int i = 0; i < arm.n(); ++i) {
        const JointLimits& limits = arm.joints[static_cast<std::size_t>(i)].limits;
        const double lower = limits.has_position ? limits.lower : -3.14;
        const double upper = limits.has_position ? limits.upper : 3.14;
        q[i] = std::uniform_real_distribution<double>(lower, upper)(generator);
      }
      Poses poses;
      forward_kinematics(arm.chain, q, poses);
      farthest = std::max(farthest, (poses.p_0T - arm.chain.p_PB0[0]).norm());
    }
    EXPECT_LE(farthest, reach(arm)) << arm.name;
    EXPECT_GT(farthest, 0.2 * reach(arm)) << arm.name;
  }
}

TEST(Reach, DoesNotDependOnWhereTheArmStands) {
  RobotModel arm = test::ur10();
  const double there = reach(arm);
  arm.chain.p_PB0[0] += Vec3(4.0, -2.0, 1.0);
  EXPECT_EQ(reach(arm), there);
}

TEST(InFrame, ThereAndBackAgainIsTheSameBody) {
  const LinkInertia body = test::random_arm(1, 5, false).chain.link[0];
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vec3 p(0.3, -0.2, 0.9);
  const LinkInertia back = in_frame(in_frame(body, R, p), R.transpose(), -(R.transpose() * p));
  EXPECT_DOUBLE_EQ(back.mass, body.mass);
  EXPECT_TRUE(back.first_moment.isApprox(body.first_moment, 1e-12));
  EXPECT_TRUE(back.inertia.isApprox(body.inertia, 1e-12));
}

TEST(Payload, ConservesMassCentreAndInertia) {
  for (const RobotModel& arm : test::all_arms()) {
    const Payload payload{1.5, Vec3(0.02, -0.03, 0.05)};
    const RobotModel loaded = with_payload(arm, payload);
    const auto last = static_cast<std::size_t>(arm.n() - 1);
    const LinkInertia& before = arm.chain.link[last];
    const LinkInertia& after = loaded.chain.link[last];
    const Vec3 p_BC = arm.chain.p_BT + arm.chain.R_BT * payload.center;
    EXPECT_DOUBLE_EQ(after.mass, before.mass + 1.5);
    EXPECT_TRUE(after.first_moment.isApprox(before.first_moment + 1.5 * p_BC, 1e-12)) << arm.name;
    // Kinetic energy of a turn at w: the arm's own plus that of a point at speed |w x p|.
    for (const Vec3& w : {Vec3(1, 0, 0), Vec3(0.3, -1, 0.5), Vec3(0, 2, 1)})
      EXPECT_NEAR(w.dot(after.inertia * w), w.dot(before.inertia * w) + 1.5 * w.cross(p_BC).squaredNorm(),
                  1e-12)
          << arm.name;
    for (std::size_t k = 0; k < last; ++k) EXPECT_EQ(loaded.chain.link[k].mass, arm.chain.link[k].mass);
    EXPECT_NO_THROW(validate(loaded));
  }
}

TEST(Payload, NegativeMassIsRefused) {
  const RobotModel arm = test::seven_joint_arm();
  EXPECT_THAT(
      [&] {
        with_payload(arm, {-0.5, Vec3::Zero()});
      },
      test::refused_at(
          {.file = "", .key = "payload/mass", .value = "-0.5", .limit = "a finite number of kg, 0 or more"}));
}

}  // namespace robot_model_test
}  // namespace armtune::internal
