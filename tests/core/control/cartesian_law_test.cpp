#include "core/control/task_resolution.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace cartesian_law_test {

using test::random_vector;
using test::WorstError;

struct Case {
  CartesianErrors x;
  Vec6 Kp, Ki;
  JointVector q, qd;
  MeasuredArm arm;
};

/// A random case of the law; Jacobian and derivative are those of a moving arm.
void fill(Case& c, std::mt19937& generator, const RobotModel& arm, double threshold) {
  const auto vec6 = [&](double bound) { return Vec6(random_vector(generator, 6, bound)); };
  c.x = {vec6(0.3), vec6(0.5), vec6(0.2), vec6(1.0), vec6(2.0)};
  c.Kp = vec6(50.0).cwiseAbs();
  c.Ki = vec6(5.0).cwiseAbs();
  c.q = test::random_configuration(generator, arm);
  c.qd = random_vector(generator, arm.n(), 1.0);
  c.arm.measure(arm.chain, c.q, c.qd, {threshold, 0.05}, TaskMask::kPose);
  c.arm.differentiate(arm.chain, c.qd);
}

JointReference references(const Case& c) {
  JointReference reference;
  const JointVector none = JointVector::Zero(c.q.size());
  resolve(task_reference(c.x, c.Kp, c.Ki), c.arm, {none, none}, c.q, c.qd, reference);
  return reference;
}

TEST(CartesianReferences, GiveTheTaskReferencesWhereTheInverseIsExact) {
  std::mt19937 generator(531);
  WorstError velocity("J qr' = xr'", 1e-9);  // condition of J J^T, up to 1e5 above the threshold
  WorstError acceleration("J qr'' + J' qr' = xr''", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.n() < 6) continue;
    for (int sample = 0; sample < 50; ++sample) {
      Case c;
      fill(c, generator, arm, 0.01);
      if (c.arm.inverse.damped()) continue;
      const JointReference r = references(c);
      Vec6 xr_dot, xr_ddot;
      for (int i = 0; i < 6; ++i) {
        xr_dot[i] = c.x.desired_rate[i] - c.Kp[i] * c.x.pose[i] - c.Ki[i] * c.x.integral[i];
        xr_ddot[i] = c.x.desired_accel[i] - c.Kp[i] * c.x.rate[i] - c.Ki[i] * c.x.pose[i];
      }
      velocity.compare(Vec6(c.arm.J * r.velocity), xr_dot, arm.name);
      acceleration.compare(Vec6(c.arm.J * r.acceleration + c.arm.J_dot * r.velocity), xr_ddot, arm.name);
    }
  }
}

TEST(CartesianReferences, UseTheDampedInverseForBothReferencesNearASingularity) {
  std::mt19937 generator(532);
  WorstError worst("damped", 1e-11);  // rounding at the condition psi leaves
  for (const RobotModel& arm : test::all_arms()) {
    Case c;
    fill(c, generator, arm, 1e9);
    const JointReference r = references(c);
    const Eigen::MatrixXd JJt = c.arm.J * c.arm.J.transpose() + 0.05 * Eigen::MatrixXd::Identity(6, 6);
    const Eigen::MatrixXd J_plus = c.arm.J.transpose() * JJt.inverse();
    const Vec6 xr_dot = c.x.desired_rate - c.Kp.cwiseProduct(c.x.pose) - c.Ki.cwiseProduct(c.x.integral);
    const Vec6 xr_ddot = c.x.desired_accel - c.Kp.cwiseProduct(c.x.rate) - c.Ki.cwiseProduct(c.x.pose);
    const JointVector qr_dot = J_plus * xr_dot;
    worst.compare(r.velocity, qr_dot, arm.name);
    // More joints than six go on moving beside the task: core/control/task_resolution.hpp.
    if (arm.n() != 6) continue;
    worst.compare(r.acceleration, JointVector(J_plus * (xr_ddot - c.arm.J_dot * qr_dot)), arm.name);
  }
}

/// The references of a UR10 when one error alone is not zero.
struct Response {
  Vec6 velocity, acceleration;  ///< J qr', J qr'' + J' qr'
};
Response response(const std::function<void(CartesianErrors&)>& set) {
  std::mt19937 generator(533);
  Case c;
  do {
    fill(c, generator, test::ur10(), 0.1);
  } while (c.arm.inverse.damped());
  c.x = {};
  c.Kp.setConstant(10.0);
  c.Ki.setConstant(2.0);
  set(c.x);
  const JointReference r = references(c);
  return {c.arm.J * r.velocity, c.arm.J * r.acceleration + c.arm.J_dot * r.velocity};
}

TEST(CartesianReferences, WithoutRollFeedbackTheTurnAboutTheAxisIsTheDesiredOneAndTheRestStays) {
  std::mt19937 generator(533);
  const RobotModel arm = test::ur10();
  for (int sample = 0; sample < 20; ++sample) {
    Case c;
    fill(c, generator, arm, 0.01);
    const Vec3 z = test::random_vec3(generator, 1.0).normalized();
    const TaskReference with = task_reference(c.x, c.Kp, c.Ki);
    TaskReference without = with;
    without_roll_feedback(c.x, z, without);
    EXPECT_NEAR(z.dot(without.rate.tail<3>()), z.dot(c.x.desired_rate.tail<3>()), 1e-12);
    EXPECT_NEAR(z.dot(without.acceleration.tail<3>()), z.dot(c.x.desired_accel.tail<3>()), 1e-12);
    for (const auto& [a, b] :
         {std::pair{with.rate, without.rate}, std::pair{with.acceleration, without.acceleration}}) {
      EXPECT_EQ(Vec3(a.head<3>()), Vec3(b.head<3>()));
      EXPECT_LT(z.cross(a.tail<3>() - b.tail<3>()).norm(), 1e-12);
      EXPECT_GT((a - b).norm(), 1e-3) << "or nothing was taken out";
    }
  }
}

TEST(CartesianReferences, OppositeToTheErrorOnEveryAxis) {
  for (int i = 0; i < 6; ++i) {
    const Response r = response([i](CartesianErrors& x) { x.pose[i] = 0.1; });
    EXPECT_NEAR(r.velocity[i], -1.0, 1e-9) << "Kp dx, axis " << i;
    EXPECT_NEAR(r.acceleration[i], -0.2, 1e-9) << "Ki dx, axis " << i;
  }
}

TEST(CartesianReferences, OppositeToTheErrorsIntegralAndRate) {
  for (int i = 0; i < 6; ++i) {
    const Response integral = response([i](CartesianErrors& x) { x.integral[i] = 0.1; });
    EXPECT_NEAR(integral.velocity[i], -0.2, 1e-9) << "Ki int(dx), axis " << i;
    EXPECT_NEAR(integral.acceleration[i], 0.0, 1e-9);
    const Response rate = response([i](CartesianErrors& x) { x.rate[i] = 0.1; });
    EXPECT_NEAR(rate.velocity[i], 0.0, 1e-9);
    EXPECT_NEAR(rate.acceleration[i], -1.0, 1e-9) << "Kp dx', axis " << i;
  }
}

TEST(CartesianReferences, CarryTheDesiredMotionForward) {
  for (int i = 0; i < 6; ++i) {
    const Response rate = response([i](CartesianErrors& x) { x.desired_rate[i] = 0.3; });
    EXPECT_NEAR(rate.velocity[i], 0.3, 1e-9);
    EXPECT_NEAR(rate.acceleration[i], 0.0, 1e-9);
    const Response accel = response([i](CartesianErrors& x) { x.desired_accel[i] = 0.3; });
    EXPECT_NEAR(accel.velocity[i], 0.0, 1e-9);
    EXPECT_NEAR(accel.acceleration[i], 0.3, 1e-9);
  }
}

}  // namespace cartesian_law_test
}  // namespace armtune::internal
