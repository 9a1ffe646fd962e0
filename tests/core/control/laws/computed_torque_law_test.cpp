#include "core/control/laws/computed_torque_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/core/support/law_period.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace computed_torque_law_test {

using test::Period;
using test::WorstError;

// The promise itself: what the torque makes of the arm, by articulated bodies, is (E s)' = -E D E^T E s with
// s = x' - xr'. E turns with the tool, and s along the motion from the state on, so that both are
// differentiated by differences.
TEST(ComputedTorqueLaw, MakesTheTasksErrorsALinearSystem) {
  WorstError linear("(E s)' = -E D E^T E s", 1e-6);
  for (const auto& [model, mask] : test::arms_and_tasks()) {
    Period p(model, "computed_torque", 61, mask);
    for (int sample = 0; sample < 20; ++sample, p.move()) {
      if (!p.is_regular()) continue;
      const JointVector qdd = p.acceleration(p.torque());
      const auto E_s = [&](double t) -> Eigen::VectorXd {
        const JointVector q = p.measured.q + t * p.measured.qd + 0.5 * t * t * qdd;
        const Vec6 rate = test::tool_jacobian_at(p.model.chain, q) * (p.measured.qd + t * qdd);
        const Poses poses = test::poses_at(p.model.chain, q);
        return test::rows_of(p.mask, poses.R_0T) * (rate - p.task.rate - t * p.task.acceleration);
      };
      const Eigen::MatrixXd E = test::rows_of(mask, p.arm.poses.R_0T);
      const Vec6 D = own(p.gains, "computed_torque_d");
      const Eigen::VectorXd wanted = -E * D.asDiagonal() * E.transpose() * E_s(0.0);
      linear.compare(Eigen::VectorXd(test::derivative(E_s, 1e-4)), wanted, p.where(), 1.0);
    }
  }
}

TEST(ComputedTorqueLaw, DampsWhatTheTaskLeavesFree) {
  WorstError damped("N (q'' - qr'' + d S) = 0", 1e-8);
  Period p(test::seven_joint_arm(), "computed_torque", 62);
  const double d = own(p.gains, "computed_torque_joint_d")[0];
  for (int sample = 0; sample < 40; ++sample, p.move()) {
    if (!p.is_regular()) continue;
    const JointVector left = p.acceleration(p.torque()) - p.control.reference.acceleration + d * p.control.S;
    // The free motion of seven joints: what J takes to zero.
    const Eigen::MatrixXd J = p.arm.J;
    const Eigen::VectorXd free = Eigen::FullPivLU<Eigen::MatrixXd>(J).kernel().col(0).normalized();
    damped.add(std::abs(free.dot(left)) / (1.0 + left.norm()), p.where());
  }
}

TEST(ComputedTorqueLaw, TracksJointsAsALinearSystemToo) {
  WorstError linear("q'' = qr'' - d S", 1e-9);
  for (const RobotModel& model : test::all_arms()) {
    Period p(model, "computed_torque", 63);
    p.control.state = ControlState::kLeaveSingularity;
    const double d = own(p.gains, "computed_torque_joint_d")[0];
    linear.compare(p.acceleration(p.torque()), p.control.reference.acceleration - d * p.control.S, p.where(),
                   1.0);
  }
}

}  // namespace computed_torque_law_test
}  // namespace armtune::internal
