#include "core/robot/holding_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace holding_load_test {

/// Potential energy of the arm's links [J].
double energy(const Chain& chain, const JointVector& q) {
  Poses poses;
  forward_kinematics(chain, q, poses);
  double sum = 0.0;
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LinkInertia& link = chain.link[k];
    sum -= chain.gravity.dot(link.mass * poses.p_0B[k] + poses.R_0B[k] * link.first_moment);
  }
  return sum;
}

TEST(HoldingLoad, IsTheLargestShareOfAnEffortLimitThatTheSlopeOfTheEnergyTakes) {
  for (const RobotModel& arm : test::all_arms()) {
    const JointVector q = JointVector::LinSpaced(arm.n(), -0.4, 0.7);
    const JointVector efforts = JointVector::LinSpaced(arm.n(), 90.0, 20.0);
    double most = 0.0;
    int joint = 0;
    for (int i = 0; i < arm.n(); ++i) {
      const JointVector step = 1e-5 * JointVector::Unit(arm.n(), i);
      const double torque = (energy(arm.chain, q + step) - energy(arm.chain, q - step)) / 2e-5;
      if (std::abs(torque) / efforts[i] > most) {
        most = std::abs(torque) / efforts[i];
        joint = i;
      }
    }
    const HoldingLoad load = holding_load(arm.chain, q, efforts);
    EXPECT_NEAR(load.share, most, 1e-6 * (1.0 + most));
    EXPECT_EQ(load.joint, joint);
  }
}

}  // namespace holding_load_test
}  // namespace armtune::internal
