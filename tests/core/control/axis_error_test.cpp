// A task that leaves the turn about the tool's z axis free: that turn changes nothing of what the controller
// asks for, however unequal the gains of its axes are.

#include "core/control/axis_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/control/control_logic.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace axis_error_test {

using test::random_vector;
constexpr double kRounding = 1e-12;

Mat3 random_rotation(std::mt19937& generator) {
  return test::random_orientation(generator).toRotationMatrix();
}
Mat3 rolled(const Mat3& R_0T, double angle) {
  return R_0T * Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

TEST(AxisError, TurnsTheAxisOntoTheDesiredOneAndIsThatOfAnyRoll) {
  std::mt19937 generator(3);
  for (int i = 0; i < 50; ++i) {
    const Mat3 R_0T = random_rotation(generator), desired = random_rotation(generator);
    const Vec3 error = axis_error(R_0T, Eigen::Quaterniond(desired));
    const Mat3 turned = rotation_exp(Vec3(-error)).toRotationMatrix() * R_0T;
    EXPECT_LT((turned.col(2) - desired.col(2)).norm(), kRounding);
    EXPECT_NEAR(error.dot(R_0T.col(2)), 0.0, kRounding) << "no turn about the axis";
    EXPECT_NEAR(error.norm(), std::acos(R_0T.col(2).dot(desired.col(2))), 1e-9) << "the shortest";
    const Vec3 same = axis_error(rolled(R_0T, 0.9), Eigen::Quaterniond(rolled(desired, -2.1)));
    EXPECT_LT((same - error).norm(), kRounding);
  }
}

TEST(AxisError, ARateKeepsWhatMovesTheAxis) {
  std::mt19937 generator(4);
  for (int i = 0; i < 20; ++i) {
    const Mat3 R_0T = random_rotation(generator);
    const Vec3 w = test::random_vec3(generator, 1.0), z = R_0T.col(2);
    const Vec3 rate = axis_rate(R_0T, w);
    EXPECT_LT((rate.cross(z) - w.cross(z)).norm(), kRounding) << "z' is the same";
    EXPECT_NEAR(rate.dot(z), 0.0, kRounding);
  }
}

/// Two controllers alike but that from the second period on the tool of one is turned about its z axis, and
/// turns about it.
class FreeTurn : public testing::TestWithParam<double> {};

TEST_P(FreeTurn, ChangesNoReferenceOfTheTask) {
  const auto arm = std::make_shared<const RobotModel>(test::ur10());
  Gains gains = test::ur10_gains();
  gains.task_space_gains_p << 80.0, 50.0, 50.0, 25.0, 15.0, 3.0;
  gains.task_space_gains_i.setZero();
  std::mt19937 generator(5);
  const JointState measured{test::random_configuration(generator, *arm),
                            random_vector(generator, arm->n(), 0.3)};
  Path path;
  path.center = Vec3(0.4, 0.1, 0.5);
  Scene scene;
  scene.path = &path;
  ArmView view;
  view.R_0T = random_rotation(generator);
  view.p_0T = Vec3(0.3, 0.2, 0.4);
  view.twist = random_vector(generator, 6, 0.3);
  view.manipulability = 1.0;
  view.obstacle_distance = 10.0;
  // The gaze begins at this angle from the target: below the threshold it is tracked, above it interpolated.
  const Vec3 sight = view.R_0T * Vec3(std::sin(GetParam()), 0.0, std::cos(GetParam()));
  scene.target = {view.p_0T + sight, Vec3::Zero(), Vec3::Zero()};

  ControlLogic still(arm, gains, 0.002, TaskMask::kPositionAndAxis);
  ControlLogic turning(arm, gains, 0.002, TaskMask::kPositionAndAxis);
  const double leave = gains.joint_trajectory_duration;
  for (ControlLogic* logic : {&still, &turning}) {
    logic->decide(measured, view, scene, 0.0);
    ASSERT_TRUE(logic->decide(measured, view, scene, leave));
  }
  ArmView turned = view;
  turned.R_0T = rolled(view.R_0T, 0.8);
  turned.twist.tail<3>() += 0.7 * view.R_0T.col(2);
  ASSERT_TRUE(still.decide(measured, view, scene, leave + 0.3));
  ASSERT_TRUE(turning.decide(measured, turned, scene, leave + 0.3));
  EXPECT_EQ(still.output().slerping, GetParam() > gains.slerpAngularErrorThreshold);
  const TaskReference &a = still.task_reference(), &b = turning.task_reference();
  EXPECT_GT(a.rate.tail<3>().norm(), 1e-2) << "there is something to track";
  EXPECT_LT((a.rate - b.rate).norm(), kRounding);
  EXPECT_LT((a.acceleration - b.acceleration).norm(), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(GazeErrors, FreeTurn, testing::Values(0.1, 0.9));

}  // namespace axis_error_test
}  // namespace armtune::internal
