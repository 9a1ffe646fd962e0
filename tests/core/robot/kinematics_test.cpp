#include "core/robot/kinematics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace kinematics_test {

using test::derivative;
using test::WorstError;

constexpr int kSamples = 10;

/// Turn from R_a to R_b as a rotation vector, by Eigen's own logarithm.
Vec3 turn(const Mat3& R_a, const Mat3& R_b) {
  const Eigen::AngleAxisd angle_axis(Mat3(R_b * R_a.transpose()));
  return angle_axis.angle() * angle_axis.axis();
}

/// Angular velocity of a moving frame R(t) at t = 0: [w]x = R' R^T.
template <typename F>
Vec3 angular_velocity(const F& R, double h) {
  const Mat3 W = derivative(R, h) * R(0.0).transpose();
  return 0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
}

TEST(ForwardKinematics, IsTheProductOfTheJointsTransforms) {
  std::mt19937 generator(101);
  WorstError worst("pose", 1e-13);  // at most 12 products of rotations, each rounds at 1e-16
  for (const RobotModel& arm : test::all_arms()) {
    const Chain& chain = arm.chain;
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses poses = test::poses_at(chain, q);
      Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
      for (int i = 0; i < chain.n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        T.translate(chain.p_PB0[k]).rotate(chain.R_PB0[k]);
        if (chain.motion[k] == JointMotion::kRevolute) {
          T.rotate(Eigen::AngleAxisd(q[i], Vec3::UnitZ()));
        } else {
          T.translate(q[i] * Vec3::UnitZ());
        }
        worst.compare(poses.R_0B[k], Mat3(T.linear()), arm.name);
        worst.compare(poses.p_0B[k], Vec3(T.translation()), arm.name, 0.1);
      }
      T.translate(chain.p_BT).rotate(chain.R_BT);
      worst.compare(poses.R_0T, Mat3(T.linear()), arm.name);
      worst.compare(poses.p_0T, Vec3(T.translation()), arm.name, 0.1);
    }
  }
}

TEST(ToolJacobian, ColumnsAreTheDerivativesOfTheToolsPoseLinearRowsFirst) {
  std::mt19937 generator(102);
  // The position is a sinusoid of each angle: the five-point difference at h = 1e-3 errs by 1e-13.
  WorstError linear("linear", 1e-10);
  WorstError angular("angular", 1e-10);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Jacobian J = test::tool_jacobian_at(arm.chain, q);
      ASSERT_EQ(J.cols(), arm.n());
      for (int i = 0; i < arm.n(); ++i) {
        const auto at = [&](double t) {
          JointVector moved = q;
          moved[i] += t;
          return test::poses_at(arm.chain, moved);
        };
        const Vec3 v = derivative([&](double t) { return Vec3(at(t).p_0T); });
        const double h = 1e-3;
        // log(R(q + h) R(q - h)^T) / 2h has no truncation error: one joint turns about one axis.
        const Vec3 w = turn(at(-h).R_0T, at(h).R_0T) / (2.0 * h);
        linear.compare(Vec3(J.col(i).head<3>()), v, arm.name, 0.1);
        angular.compare(Vec3(J.col(i).tail<3>()), w, arm.name, 0.1);
      }
    }
  }
}

TEST(PointJacobian, IsTheDerivativeOfAPointFixedInItsBodyAndZeroBeyond) {
  std::mt19937 generator(103);
  WorstError worst("velocity", 1e-10);  // as for the tool
  for (const RobotModel& arm : test::all_arms()) {
    for (int body = 0; body < arm.n(); ++body) {
      const auto k = static_cast<std::size_t>(body);
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 0.5);
      const Vec3 p_B = test::random_vec3(generator, 0.5);
      const auto pose = [&](double t) { return test::poses_at(arm.chain, q + t * qd); };
      const auto point = [&](double t) {
        const Poses poses = pose(t);
        return Vec3(poses.p_0B[k] + poses.R_0B[k] * p_B);
      };
      Jacobian J;
      point_jacobian(arm.chain, pose(0.0), body, point(0.0), J);
      const Vec6 twist = J * qd;
      const auto R = [&](double t) { return Mat3(pose(t).R_0B[k]); };
      worst.compare(Vec3(twist.head<3>()), derivative(point), arm.name, 0.1);
      worst.compare(Vec3(twist.tail<3>()), angular_velocity(R, 1e-3), arm.name, 0.1);
      EXPECT_TRUE(J.rightCols(arm.n() - 1 - body).isZero(0.0)) << arm.name;
    }
  }
}

TEST(ToolJacobianDerivative, IsTheDerivativeOfTheJacobianAlongTheMotion) {
  std::mt19937 generator(104);
  // Joints at up to 1 rad/s turn the tool at some 5 rad/s: 5^5 h^4 / 30 = 1e-10 of J' at h = 1e-3.
  WorstError worst("J'", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      const Poses poses = test::poses_at(arm.chain, q);
      const Jacobian J = test::tool_jacobian_at(arm.chain, q);
      Jacobian J_dot;
      tool_jacobian_derivative(arm.chain, poses, J, qd, J_dot);
      const Jacobian difference =
          derivative([&](double t) { return test::tool_jacobian_at(arm.chain, q + t * qd); });
      worst.compare(J_dot, difference, arm.name);
    }
  }
}

TEST(ToolJacobianDerivative, GivesTheToolsAccelerationTogetherWithTheJacobian) {
  std::mt19937 generator(105);
  // From poses alone, differenced twice: 1e-16 / h^2 = 1e-10 of rounding, and the truncation of J' at twice
  // h.
  WorstError worst("acceleration", 1e-8);
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < 3; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 2.0);
      const auto pose = [&](double t) { return test::poses_at(arm.chain, q + t * qd + (0.5 * t * t) * qdd); };
      const auto twist = [&](double t) {
        Vec6 x;
        x << derivative([&](double s) { return Vec3(pose(t + s).p_0T); }),
            angular_velocity([&](double s) { return Mat3(pose(t + s).R_0T); }, 1e-3);
        return x;
      };
      const Jacobian J = test::tool_jacobian_at(arm.chain, q);
      Jacobian J_dot;
      tool_jacobian_derivative(arm.chain, pose(0.0), J, qd, J_dot);
      worst.compare(Vec6(J * qdd + J_dot * qd), derivative(twist, 2e-3), arm.name);
    }
  }
}

}  // namespace kinematics_test
}  // namespace armtune::internal
