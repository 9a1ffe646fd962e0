#include "core/control/laws/impedance_law.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/core/support/law_period.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace impedance_law_test {

using test::Period;
using test::WorstError;

/// The desired motion as the only reference, as Kp and Ki are zero.
void at_rest(Period& p) {
  p.measured.qd.setZero();
  p.control.reference.velocity.setZero(p.model.n());
  p.control.reference.acceleration.setZero(p.model.n());
  p.control.S.setZero(p.model.n());
  p.arm.measure(p.model.chain, p.measured.q, p.measured.qd, {0.0, 0.05, 0.0}, p.mask);
  p.arm.differentiate(p.model.chain, p.measured.qd);
}

TEST(ImpedanceLaw, AtRestIsGravityAndASpringTowardsTheDesiredPose) {
  WorstError spring("tau = g - J^T E^T E K E^T E dx", 1e-10);
  for (const auto& [model, mask] : test::arms_and_tasks()) {
    Period p(model, "impedance", 71, mask);
    at_rest(p);
    const Eigen::MatrixXd E = test::rows_of(mask, p.arm.poses.R_0T);
    const Eigen::MatrixXd P = E.transpose() * E;
    const Vec6 K = own(p.gains, "impedance_k");
    const Eigen::VectorXd force = P * K.asDiagonal() * P * p.control.errors.pose;
    const JointVector wanted =
        test::gravity_torque_at(model.chain, p.measured.q) - JointVector(p.arm.J.transpose() * force);
    spring.compare(p.torque(), wanted, p.where());
  }
}

// The closed loop by articulated bodies: M (q'' - qr'') + C S = -J^T F - B S, in which the Slotine-Li C works
// no power of its own: S . (M (q'' - qr'') + M' S / 2) is the power of spring and dampers.
TEST(ImpedanceLaw, OnlySpringAndDampersWorkOnTheErrorOfTheMotion) {
  WorstError power("S . (M S' + M' S / 2) = -S . (J^T F + B S)", 1e-6);
  for (const auto& [model, mask] : test::arms_and_tasks()) {
    Period p(model, "impedance", 72, mask);
    for (int sample = 0; sample < 10; ++sample, p.move()) {
      const JointVector& S = p.control.S;
      const JointVector S_dot = p.acceleration(p.torque()) - p.control.reference.acceleration;
      const auto M_of = [&](double t) {
        return JointMatrix(test::mass_matrix_at(p.model.chain, p.measured.q + t * p.measured.qd));
      };
      const double left = S.dot(p.mass() * S_dot) + 0.5 * S.dot(test::derivative(M_of, 1e-4) * S);
      const Eigen::MatrixXd E = test::rows_of(mask, p.arm.poses.R_0T);
      const Eigen::VectorXd tool = E.transpose() * E * (p.arm.J * S);
      const Eigen::VectorXd dx = E.transpose() * E * p.control.errors.pose;
      const Vec6 K = own(p.gains, "impedance_k"), D = own(p.gains, "impedance_d");
      const double springs = tool.dot(K.asDiagonal() * dx);
      const double dampers =
          tool.dot(D.asDiagonal() * tool) + own(p.gains, "impedance_joint_d").cwiseProduct(S).dot(S);
      power.compare(left, -springs - dampers, p.where(), 1.0);
    }
  }
}

TEST(ImpedanceLaw, TracksJointsWithTheJointSpaceLaw) {
  Period p(test::ur10(), "impedance", 73);
  p.control.state = ControlState::kLeaveSingularity;
  const JointVector with = p.torque();
  const JointVector Kd = p.Kd;
  p.Kd.setZero();
  EXPECT_LT((with - p.torque() + Kd.cwiseProduct(p.control.S)).norm(), 1e-9 * with.norm());
  // And nothing of spring and damper.
  p.control.errors.pose *= 2.0;
  const JointVector without = p.torque();
  p.control.errors.pose.setZero();
  EXPECT_EQ(p.torque(), without);
}

}  // namespace impedance_law_test
}  // namespace armtune::internal
